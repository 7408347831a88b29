// SPDX-License-Identifier: Apache-2.0
// Optimal allocations of small instances, sharing nothing with the auction.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "skein/auction/task.hpp"

namespace skein::auction::testing {

inline double metres(Place a, Place b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Shortest open tours from `begin` over each subset of the tasks: Held and Karp's recursion.
inline std::vector<double> shortest_tours(Place begin, const std::vector<Place>& tasks) {
  const std::size_t n = tasks.size();
  std::vector<std::vector<double>> last(1U << n, std::vector<double>(n, 1e18));
  std::vector<double> shortest(1U << n, 0);
  for (std::size_t i = 0; i < n; ++i) last[1U << i][i] = metres(begin, tasks[i]);
  for (std::uint32_t set = 1; set < (1U << n); ++set) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if ((set >> j & 1U) != 0) continue;
        double& way = last[set | 1U << j][j];
        way = std::min(way, last[set][i] + metres(tasks[i], tasks[j]));
      }
    }
    shortest[set] = *std::min_element(last[set].begin(), last[set].end());
  }
  return shortest;
}

/// The least sum, or the least longest tour, over all ways to split the tasks.
inline double best_tours(const std::vector<Place>& begins, const std::vector<Place>& tasks,
                         bool longest) {
  std::vector<double> best = shortest_tours(begins[0], tasks);
  for (std::size_t v = 1; v < begins.size(); ++v) {
    const auto own = shortest_tours(begins[v], tasks);
    std::vector<double> with(best.size(), 1e18);
    for (std::uint32_t set = 0; set < best.size(); ++set) {
      for (std::uint32_t part = set;; part = (part - 1) & set) {
        const double a = best[part], b = own[set ^ part];
        with[set] = std::min(with[set], longest ? std::max(a, b) : a + b);
        if (part == 0) break;
      }
    }
    best = std::move(with);
  }
  return best.back();
}

/// Robots with skills, tasks that need several: the least makespan by trying every order of starts
/// and every group (a schedule in order of its starts is the earliest of that order).
class ExactGroups {
 public:
  ExactGroups(const Lot& lot, std::vector<Abilities> robots, Place begin, Place end)
      : lot_(&lot),
        robots_(std::move(robots)),
        end_(end),
        at_(robots_.size(), begin),
        free_(robots_.size(), 0),
        ended_(lot.tasks.size(), -1) {}

  double solve() {
    search(0);
    return best_;
  }

 private:
  bool waits(std::size_t task) const {
    return std::any_of(lot_->precedences.begin(), lot_->precedences.end(),
                       [&](const Precedence& p) {
                         return p.then == lot_->tasks[task].number && ended_[index(p.first)] < 0;
                       });
  }
  std::size_t index(TaskNumber number) const {
    std::size_t i = 0;
    while (lot_->tasks[i].number != number) ++i;
    return i;
  }
  double after_predecessors(std::size_t task) const {
    double start = 0;
    for (const Precedence& p : lot_->precedences) {
      if (p.then == lot_->tasks[task].number) start = std::max(start, ended_[index(p.first)]);
    }
    return start;
  }
  void search(std::size_t done) {
    double makespan = 0;
    for (std::size_t r = 0; r < robots_.size(); ++r) {
      makespan = std::max(makespan, free_[r] + (free_[r] > 0 ? metres(at_[r], end_) : 0));
    }
    if (makespan >= best_) return;
    if (done == lot_->tasks.size()) {
      best_ = makespan;
      return;
    }
    for (std::size_t t = 0; t < lot_->tasks.size(); ++t) {
      if (ended_[t] >= 0 || waits(t)) continue;
      for (std::uint32_t group = 1; group < (1U << robots_.size()); ++group)
        try_group(done, t, group);
    }
  }
  void try_group(std::size_t done, std::size_t t, std::uint32_t group) {
    const Task& task = lot_->tasks[t];
    Abilities all = 0;
    double start = after_predecessors(t);
    for (std::size_t r = 0; r < robots_.size(); ++r) {
      if ((group >> r & 1U) == 0) continue;
      all |= robots_[r];
      start = std::max(start, free_[r] + metres(at_[r], task.at));
    }
    if ((task.needs & ~all) != 0) return;
    const auto at = at_;
    const auto free = free_;
    ended_[t] = start + task.duration;
    for (std::size_t r = 0; r < robots_.size(); ++r) {
      if ((group >> r & 1U) == 0) continue;
      at_[r] = task.at;
      free_[r] = ended_[t];
    }
    search(done + 1);
    at_ = at;
    free_ = free;
    ended_[t] = -1;
  }

  const Lot* lot_;
  std::vector<Abilities> robots_;
  Place end_;
  std::vector<Place> at_;
  std::vector<double> free_, ended_;
  double best_ = 1e18;
};

}  // namespace skein::auction::testing
