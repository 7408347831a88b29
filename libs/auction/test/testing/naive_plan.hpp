// SPDX-License-Identifier: Apache-2.0
// A team's routes judged the slow way: by walking them.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "testing/road_team.hpp"

namespace skein::auction {

/// Dates by relaxation until nothing moves, cost and energy leg by leg. Shares nothing with Draft
/// but the objective.
class NaivePlan {
 public:
  using Routes = std::vector<std::vector<TaskNumber>>;
  NaivePlan(const RoadSale& team, Routes routes)
      : lot_(team.catalogue.get()), crafts_(&team.crafts), routes_(std::move(routes)) {}

  /// None: a circle of waits, a deadline missed, or a battery too small.
  std::optional<Value> value(Aim aim) {
    if (!date() || !lasts()) return std::nullopt;
    double cost = 0, end = 0, ends = 0;
    std::set<TaskNumber> done;
    for (std::size_t r = 0; r < routes_.size(); ++r) {
      if (routes_[r].empty()) continue;
      done.insert(routes_[r].begin(), routes_[r].end());
      for (const Leg& leg : legs(r)) cost += leg.cost;
      end = std::max(end, end_of(routes_[r].back()) + legs(r).back().seconds);
    }
    for (const TaskNumber task : done) ends += end_of(task);
    const auto unsold = static_cast<std::uint32_t>(lot_->size() - done.size());
    Value value = value_of(aim, unsold, cost, end);
    value.ends = ends;
    return value;
  }
  double start(TaskNumber task) const { return start_[lot_->index(task)]; }

 private:
  std::vector<Leg> legs(std::size_t r) const {
    std::vector<Leg> legs;
    Stopover from = Stopover::begin();
    for (const TaskNumber task : routes_[r]) {
      legs.push_back(*(*crafts_)[r].leg(from, Stopover::of(task)));
      from = Stopover::of(task);
    }
    legs.push_back(*(*crafts_)[r].leg(from, Stopover::end()));
    return legs;
  }
  double end_of(TaskNumber task) const { return start(task) + lot_->task(task).duration; }
  bool is_planned(TaskNumber task) const {
    return std::any_of(routes_.begin(), routes_.end(), [&](const auto& route) {
      return std::find(route.begin(), route.end(), task) != route.end();
    });
  }
  bool relax(TaskNumber task, double earliest) {
    double& start = start_[lot_->index(task)];
    if (earliest <= start) return false;
    start = earliest;
    return true;
  }
  double way_to(TaskNumber task) const {
    double longest = 0;
    for (std::size_t r = 0; r < routes_.size(); ++r) {
      const auto way = legs(r);
      for (std::size_t i = 0; i < routes_[r].size(); ++i)
        if (routes_[r][i] == task) longest = std::max(longest, way[i].seconds);
    }
    return longest;
  }
  bool relax_all() {
    bool moved = false;
    for (std::size_t r = 0; r < routes_.size(); ++r) {
      const auto way = legs(r);
      double free = (*crafts_)[r].free_from();
      for (std::size_t i = 0; i < routes_[r].size(); ++i) {
        moved |= relax(routes_[r][i], free + way[i].seconds);
        free = end_of(routes_[r][i]);
      }
    }
    for (const auto& [first, then, delay] : lot_->lot().precedences) {
      if (!is_planned(first) || !is_planned(then)) continue;
      const double way = delay.bounds() ? way_to(then) : 0;
      moved |= relax(then, end_of(first) + delay.least + way);
      if (start(then) > end_of(first) + delay.most)
        moved |= relax(first, start(then) - delay.most - lot_->task(first).duration);
    }
    return moved;
  }
  bool date() {
    start_.clear();
    for (const Task& task : lot_->lot().tasks) start_.push_back(task.earliest);
    std::size_t passes = 0;
    while (relax_all()) {
      if (++passes > 4 * lot_->size() * lot_->size() + 2) return false;
    }
    return std::all_of(lot_->lot().tasks.begin(), lot_->lot().tasks.end(), [&](const Task& t) {
      return !is_planned(t.number) || end_of(t.number) <= t.deadline;
    });
  }
  bool lasts() const {
    for (std::size_t r = 0; r < routes_.size(); ++r) {
      double spent = (*crafts_)[r].work * static_cast<double>(routes_[r].size());
      for (const Leg& leg : legs(r)) spent += leg.energy;
      if (!routes_[r].empty() && spent > (*crafts_)[r].joules) return false;
    }
    return true;
  }

  const Catalogue* lot_;
  const std::deque<RoadCraft>* crafts_;
  Routes routes_;
  std::vector<double> start_;
};

}  // namespace skein::auction
