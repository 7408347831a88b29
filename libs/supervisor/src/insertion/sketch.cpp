// SPDX-License-Identifier: Apache-2.0
// What each high-level task takes in time, place and energy, read off a plan of all of them.
#include "insertion/sketch.hpp"

#include <algorithm>
#include <cmath>

#include "skein/refiners/flight.hpp"

namespace skein::supervisor {
namespace {

using mission::ElementaryTask;
using world::Vector3;

/// A date that nothing bounds counts as this far away [s].
constexpr double kFarAway = 1e6;

/// From one place to another, up or down too slowly to count.
bool flies(const ElementaryTask& task) {
  const functional::TaskType& type = mission::type_of(task);
  return type.motion == functional::Motion::kMoves && type.leaves == functional::Leaves::kAsItWas &&
         task.way.size() > 1;
}

double bounded(Duration duration) { return std::min(duration.to_seconds(), kFarAway); }

/// Dates of one high-level task in the plan, relative to its origin [s].
class Extent {
 public:
  void add(const ElementaryTask& task) {
    const double start = bounded(task.start.most);
    begin_ = std::min(begin_, start);
    begin_least_ = std::min(begin_least_, bounded(task.start.least));
    last_start_ = std::max(last_start_, start);
    if (!task.open_ended) end_ = std::max(end_, start + bounded(task.duration.most));
    first_end_ = std::min(first_end_, bounded(task.start.least) + bounded(task.duration.least));
    energy_ += task.energy;
    if (!task.way.empty()) follow(task);
  }

  Stay stay() const {
    Stay stay = stay_;
    stay.last_start = std::max(last_start_ - begin_ - stay.approach, 0.0);
    stay.inside = std::max(std::max(end_, last_start_) - begin_ - stay.approach, 0.0);
    stay.first_end = std::max(first_end_ - begin_least_, 0.0);
    stay.energy = energy_;
    return stay;
  }

 private:
  void follow(const ElementaryTask& task) {
    stay_.exit = task.way.back();
    if (stay_.moves) return;
    stay_.moves = true;
    const bool leads_there = flies(task);
    stay_.entry = leads_there ? task.way.back() : task.way.front();
    if (!leads_there) return;
    stay_.approach = bounded(task.duration.most);
    stay_.approach_energy = task.energy;
  }

  Stay stay_;
  double begin_ = kFarAway, begin_least_ = kFarAway, first_end_ = kFarAway;
  double last_start_ = 0, end_ = 0, energy_ = 0;
};

}  // namespace

Sketch::Sketch(const mission::ElementaryPlan& plan, double cruise_speed) {
  std::map<mission::GoalId, Extent> extents;
  double length = 0, seconds = 0, energy = 0;
  for (const ElementaryTask& task : plan.tasks) {
    extents[task.origin].add(task);
    if (!flies(task)) continue;
    length += refiners::length_of(task.way);
    seconds += bounded(task.duration.most);
    energy += task.energy;
  }
  for (const auto& [goal, extent] : extents) stays_[goal] = extent.stay();
  pace_ = length > 0 ? seconds / length : 1 / std::max(cruise_speed, 1e-3);
  if (seconds > 0) flight_energy_ = energy / seconds;
}

Stay Sketch::of(mission::GoalId goal) const {
  const auto stay = stays_.find(goal);
  return stay == stays_.end() ? Stay{} : stay->second;
}

double Sketch::travel(const Vector3& from, const Vector3& to) const {
  return (to - from).norm() * pace_;
}

Saving Sketch::saving(const Goals& order, std::size_t index, const Vector3& start) const {
  const Stay gone = of(order[index].id);
  Saving saving{gone.inside + gone.approach, gone.energy};
  if (!gone.moves) return saving;
  Vector3 before = start;
  for (std::size_t i = 0; i < index; ++i)
    if (const Stay stay = of(order[i].id); stay.moves) before = stay.exit;
  for (std::size_t i = index + 1; i < order.size(); ++i) {
    const Stay next = of(order[i].id);
    if (!next.moves) continue;
    const double shorter = travel(gone.exit, next.entry) - travel(before, next.entry);
    saving.seconds += shorter;
    saving.energy += shorter * flight_energy_;
    break;
  }
  return saving;
}

}  // namespace skein::supervisor
