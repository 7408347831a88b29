// SPDX-License-Identifier: Apache-2.0
#include "interaction/planned_state.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace skein::decision_node {

namespace {

using mission::PlannedTask;

/// All that the task waits for, in the order of their ends.
std::vector<const PlannedTask*> before(const mission::PlanReport& plan, executive::TaskId task) {
  std::map<executive::TaskId, const PlannedTask*> known;
  for (const PlannedTask& one : plan.tasks) known[one.task.id] = &one;
  std::set<executive::TaskId> seen{task};
  std::vector<executive::TaskId> open{task};
  std::vector<const PlannedTask*> result;
  while (!open.empty()) {
    const auto found = known.find(open.back());
    open.pop_back();
    if (found == known.end()) continue;
    if (found->first != task) result.push_back(found->second);
    for (const mission::Dependence& on : found->second->task.dependences)
      if (seen.insert(on.task).second) open.push_back(on.task);
  }
  std::sort(result.begin(), result.end(), [](const PlannedTask* a, const PlannedTask* b) {
    return std::pair(a->dates.earliest_end, a->task.id) <
           std::pair(b->dates.earliest_end, b->task.id);
  });
  return result;
}

/// Of one that is under way, what is still to come.
double share_to_come(const mission::TaskDates& dates, MissionTime now) {
  if (dates.earliest_start >= now) return 1;
  const double whole = (dates.earliest_end - dates.earliest_start).to_seconds();
  const double left = (dates.earliest_end - now).to_seconds();
  return whole <= 0 ? 0 : std::clamp(left / whole, 0.0, 1.0);
}

}  // namespace

world::VehicleState planned_state(const world::VehicleState& seen, const mission::PlanReport& plan,
                                  executive::TaskId task, const world::VehicleModel& vehicle,
                                  MissionTime now) {
  const auto itself = std::find_if(plan.tasks.begin(), plan.tasks.end(),
                                   [&](const PlannedTask& one) { return one.task.id == task; });
  if (itself == plan.tasks.end()) return seen;
  world::VehicleState then = seen;
  MissionTime free = now;
  for (const PlannedTask* one : before(plan, task)) {
    if (one->dates.latest_end <= now) continue;
    then.energy -= one->task.energy * share_to_come(one->dates, now);
    free = std::max(free, one->dates.earliest_end);
    if (one->task.way.empty()) continue;
    then.position = one->task.way.back();
    then.airborne = one->task.type != "land";
  }
  const double waits = std::max(0.0, (itself->dates.earliest_start - free).to_seconds());
  const double power = vehicle.hovers ? vehicle.energy.hover_power : vehicle.energy.cruise_power;
  if (then.airborne && vehicle.energy.capacity > 0)
    then.energy -= power * waits / vehicle.energy.capacity;
  then.energy = std::max(0.0, then.energy);
  return then;
}

std::vector<executive::TaskId> joint_tasks_before(const mission::PlanReport& plan,
                                                  executive::TaskId task) {
  std::vector<executive::TaskId> all;
  for (const PlannedTask* one : before(plan, task))
    if (executive::is_joint(one->task.type)) all.push_back(one->task.id);
  return all;
}

}  // namespace skein::decision_node
