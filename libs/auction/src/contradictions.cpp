// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "skein/auction/catalogue.hpp"
#include "skein/auction/task.hpp"
#include "skein/foundation/time.hpp"

namespace skein::auction {

namespace {

std::string seconds(double value) { return to_text(Duration::seconds(value)) + " s"; }

/// The earliest end of each task in the order of the precedences, whoever does it, and which task
/// makes it wait.
class Chains {
 public:
  explicit Chains(const Catalogue& catalogue)
      : catalogue_(&catalogue),
        end_(catalogue.size()),
        cause_(catalogue.size(), -1),
        waiting_(catalogue.size()) {
    std::vector<std::uint32_t> ready;
    for (std::uint32_t i = 0; i < catalogue.size(); ++i) {
      waiting_[i] = catalogue.before(i).size();
      end_[i] = catalogue.task(i).earliest + catalogue.task(i).duration;
      if (waiting_[i] == 0) ready.push_back(i);
    }
    while (!ready.empty()) {
      const std::uint32_t task = ready.back();
      ready.pop_back();
      for (const std::uint32_t after : catalogue.after(task)) {
        const double end = end_[task] + catalogue.task(after).duration;
        if (end > end_[after]) {
          end_[after] = end;
          cause_[after] = static_cast<std::int64_t>(task);
        }
        if (--waiting_[after] == 0) ready.push_back(after);
      }
    }
  }

  void late(std::vector<Contradiction>& found) const {
    for (std::uint32_t i = 0; i < catalogue_->size(); ++i) {
      const Task& task = catalogue_->task(i);
      if (waiting_[i] > 0 || end_[i] <= task.deadline) continue;
      std::vector<TaskNumber> chain;
      for (std::int64_t at = i; at >= 0; at = cause_[static_cast<std::size_t>(at)]) {
        chain.push_back(catalogue_->task(static_cast<std::uint32_t>(at)).number);
      }
      std::reverse(chain.begin(), chain.end());
      found.push_back({std::move(chain), "the last cannot end before " + seconds(end_[i]) +
                                             ", its deadline is " + seconds(task.deadline)});
    }
  }

  // What is never ready is on a circle or behind one: going back from it ends on the circle.
  void circle(std::vector<Contradiction>& found) const {
    const auto stuck =
        std::find_if(waiting_.begin(), waiting_.end(), [](std::size_t n) { return n > 0; });
    if (stuck == waiting_.end()) return;
    auto at = static_cast<std::uint32_t>(stuck - waiting_.begin());
    std::vector<std::uint32_t> way;
    while (std::find(way.begin(), way.end(), at) == way.end()) {
      way.push_back(at);
      const auto& before = catalogue_->before(at);
      at = *std::find_if(before.begin(), before.end(),
                         [&](std::uint32_t b) { return waiting_[b] > 0; });
    }
    std::vector<TaskNumber> chain{catalogue_->task(at).number};
    for (auto back = way.rbegin(); back != way.rend(); ++back) {
      chain.push_back(catalogue_->task(*back).number);
      if (*back == at) break;
    }
    found.push_back({std::move(chain), "each is to end before the next begins"});
  }

 private:
  const Catalogue* catalogue_;
  std::vector<double> end_;
  std::vector<std::int64_t> cause_;
  std::vector<std::size_t> waiting_;
};

}  // namespace

std::vector<Contradiction> contradictions(const Lot& lot) {
  std::vector<Contradiction> found;
  std::map<TaskNumber, int> times;
  for (const Task& task : lot.tasks) {
    if (++times[task.number] == 2) found.push_back({{task.number}, "is given twice"});
    if (task.pinned && task.forbidden.contains(*task.pinned)) {
      found.push_back({{task.number}, "is pinned to a member that is forbidden to do it"});
    }
  }
  for (const auto& [first, then] : lot.precedences) {
    for (const TaskNumber task : {first, then}) {
      if (times.contains(task)) continue;
      found.push_back({{first, then}, "task " + to_text(task) + " is not among those to be sold"});
    }
  }
  const Catalogue catalogue(lot);
  const Chains chains(catalogue);
  chains.late(found);
  chains.circle(found);
  return found;
}

}  // namespace skein::auction
