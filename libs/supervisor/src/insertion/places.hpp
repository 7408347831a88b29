// SPDX-License-Identifier: Apache-2.0
// Where high-level tasks take the UAV.
#pragma once

#include <vector>

#include "skein/refiners/tour.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// The place at usual flight altitude over a point on the ground; a point in the air itself.
world::Vector3 over(const world::Vector3& point, const PlanningRequest& base);
/// The UAV's position; if it is on the ground, its position after a takeoff.
world::Vector3 in_the_air(const PlanningRequest& base);
/// The place at usual flight altitude over the landing place.
world::Vector3 over_home(const PlanningRequest& base);

/// Alternative entry and exit points of the task: for a place or location its point; for several
/// places every pair of them; for a zone without a place the corners where a sweep may begin.
/// Empty: the task has no place, or an unknown one. Cost: for a zone, one sweep per corner.
std::vector<refiners::Gate> gates_of(const mission::HighLevelTask& goal,
                                     const PlanningRequest& base);

/// True for tasks done with other UAVs: synchronisations and joint tasks. Two UAVs that have them
/// in different orders would wait for each other for ever.
bool is_shared(const mission::HighLevelTask& goal, const mission::Vocabulary& vocabulary);

}  // namespace skein::supervisor
