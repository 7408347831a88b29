// SPDX-License-Identifier: Apache-2.0
// Where the plan has the vehicle when a task begins.
#pragma once

#include "skein/mission/elementary_plan.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::decision_node {

/// Where the tasks before it leave the vehicle that is seen as `seen` now, and the energy that
/// they, and the wait for it, leave. Without the task in the plan, or anything before it that is
/// still to come: as it is seen. Source: spec 7.4 ("from the current state and plan").
/// Cost: O(tasks of the plan · log).
world::VehicleState planned_state(const world::VehicleState& seen, const mission::PlanReport& plan,
                                  executive::TaskId task, const world::VehicleModel& vehicle,
                                  MissionTime now);

}  // namespace skein::decision_node
