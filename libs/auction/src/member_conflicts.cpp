// SPDX-License-Identifier: Apache-2.0
#include "skein/auction/member_conflicts.hpp"

#include <algorithm>

#include "chains.hpp"
#include "one_member.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/rounded_seconds.hpp"

namespace skein::auction {

namespace {

std::string in_seconds(double value) { return skein::in_seconds(Duration::seconds(value)); }

/// Of the tasks that need a member whoever else does them, those that fit in no order.
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

  // Of several conflicts of one member each is found without the last task of those before it.
  void add_more(const std::set<MemberNumber>& members, std::vector<MemberConflict>& found) const {
    const OneMember together(catalogue_, chains_);
    std::set<std::vector<std::uint32_t>> named;
    for (const MemberNumber member : members) {
      std::vector<std::uint32_t> tasks = without_pairs(member);
      for (auto some = together.misfits(tasks); !some.empty(); some = together.misfits(tasks)) {
        if (named.insert(some).second) found.push_back({numbers(some), why_none(some), member});
        std::erase(tasks, some.back());
      }
    }
  }

 private:
  // Tasks that need the member, the later of each pair that does not fit left out.
  std::vector<std::uint32_t> without_pairs(MemberNumber member) const {
    std::vector<std::uint32_t> tasks;
    for (std::uint32_t task = 0; task < catalogue_.size(); ++task) {
      const bool fits_all = std::all_of(tasks.begin(), tasks.end(), [&](std::uint32_t other) {
        return fits(other, task) || fits(task, other);
      });
      if (needs_[task].contains(member) && fits_all) tasks.push_back(task);
    }
    return tasks;
  }
  std::vector<TaskNumber> numbers(const std::vector<std::uint32_t>& tasks) const {
    std::vector<TaskNumber> all;
    for (const std::uint32_t task : tasks) all.push_back(catalogue_.task(task).number);
    return all;
  }
  std::string why_none(const std::vector<std::uint32_t>& tasks) const {
    std::vector<std::string> each;
    for (const std::uint32_t i : tasks) {
      const Task& task = catalogue_.task(i);
      each.push_back(to_text(task.number) + " begins at " +
                     in_seconds(chains_.earliest_end(i) - task.duration) +
                     " at the earliest, lasts " + in_seconds(task.duration) + " and must end by " +
                     in_seconds(chains_.latest_end(i)));
    }
    return "they fit in no order: " + joined(each, "; ");
  }
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
  if (!chains.hold()) return found;
  shared.add_pairs(found);
  shared.add_more(members, found);
  return found;
}

}  // namespace skein::auction
