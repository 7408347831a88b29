// SPDX-License-Identifier: Apache-2.0
#include "skein/auction/member_conflicts.hpp"

#include <algorithm>

#include "chains.hpp"
#include "skein/foundation/time.hpp"

namespace skein::auction {

namespace {

std::string in_seconds(double value) { return to_text(Duration::seconds(value)) + " s"; }

/// Of the tasks that need a member whoever else does them, those that fit in neither order.
class SharedMembers {
 public:
  SharedMembers(const Catalogue& catalogue, const Chains& chains,
                const std::set<MemberNumber>& members)
      : catalogue_(catalogue), chains_(chains), needs_(catalogue.size()) {
    for (std::uint32_t i = 0; i < catalogue.size(); ++i) {
      const Task& task = catalogue.task(i);
      may_.push_back(members);
      for (const MemberNumber member : task.forbidden) may_[i].erase(member);
      const bool enough = may_[i].size() >= task.least_members;
      // What nobody can do is named by itself, and needs nobody.
      if (!enough || (task.pinned && !may_[i].contains(*task.pinned))) continue;
      if (may_[i].size() == task.least_members) needs_[i] = may_[i];
      if (task.pinned) needs_[i].insert(*task.pinned);
    }
  }

  void add_too_few(std::vector<MemberConflict>& found) const {
    for (std::uint32_t i = 0; i < catalogue_.size(); ++i) {
      const Task& task = catalogue_.task(i);
      if (may_[i].size() >= task.least_members) continue;
      found.push_back({{task.number},
                       "it is for " + std::to_string(task.least_members) + " members, and " +
                           std::to_string(may_[i].size()) + " may do it"});
    }
  }

  void add_pairs(std::vector<MemberConflict>& found) const {
    for (std::uint32_t a = 0; a < catalogue_.size(); ++a) {
      for (std::uint32_t b = a + 1; b < catalogue_.size(); ++b) {
        const auto shared = std::find_if(needs_[a].begin(), needs_[a].end(),
                                         [&](auto member) { return needs_[b].contains(member); });
        if (shared == needs_[a].end() || fits(a, b) || fits(b, a)) continue;
        found.push_back({{catalogue_.task(a).number, catalogue_.task(b).number},
                         misfit(a, b) + "; " + misfit(b, a),
                         *shared});
      }
    }
  }

 private:
  double end_after(std::uint32_t first, std::uint32_t then) const {
    return chains_.earliest_end(first) + catalogue_.task(then).duration;
  }
  bool fits(std::uint32_t first, std::uint32_t then) const {
    return end_after(first, then) <= chains_.latest_end(then);
  }
  std::string misfit(std::uint32_t first, std::uint32_t then) const {
    const Task& before = catalogue_.task(first);
    return "after " + to_text(before.number) + " (ends at " +
           in_seconds(chains_.earliest_end(first)) + " at the earliest, lasts " +
           in_seconds(before.duration) + ") " + to_text(catalogue_.task(then).number) +
           " cannot end before " + in_seconds(end_after(first, then)) + ", and must by " +
           in_seconds(chains_.latest_end(then));
  }

  const Catalogue& catalogue_;
  const Chains& chains_;
  std::vector<std::set<MemberNumber>> may_, needs_;
};

}  // namespace

std::vector<MemberConflict> member_conflicts(const Lot& lot,
                                             const std::set<MemberNumber>& members) {
  std::vector<MemberConflict> found;
  const Catalogue catalogue(lot);
  const Chains chains(catalogue);
  const SharedMembers shared(catalogue, chains, members);
  shared.add_too_few(found);
  if (chains.hold()) shared.add_pairs(found);
  return found;
}

}  // namespace skein::auction
