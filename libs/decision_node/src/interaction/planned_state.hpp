// SPDX-License-Identifier: Apache-2.0
// What comes before a task of a plan, and the vehicle's planned state at its beginning.
#pragma once

#include <vector>

#include "skein/mission/elementary_plan.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::decision_node {

/// Position and energy of the vehicle, now at `seen`, after all tasks before `task` and the wait
/// for it. If the plan does not have the task, or nothing before it is left to do: `seen` itself.
/// Source: spec 7.4 ("from the current state and plan").
/// Cost: O(tasks of the plan · log).
world::VehicleState planned_state(const world::VehicleState& seen, const mission::PlanReport& plan,
                                  executive::TaskId task, const world::VehicleModel& vehicle,
                                  MissionTime now);

/// The joint tasks for which `task` waits in the plan, also past others; none if the plan does not
/// have the task.
std::vector<executive::TaskId> joint_tasks_before(const mission::PlanReport& plan,
                                                  executive::TaskId task);

}  // namespace skein::decision_node
