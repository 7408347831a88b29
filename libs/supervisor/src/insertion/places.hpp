// SPDX-License-Identifier: Apache-2.0
// Where high-level tasks take the UAV.
#pragma once

#include <vector>

#include "skein/refiners/tour.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Over a point of the map, as high as flights are; the point itself when that is higher.
world::Vector3 over(const world::Vector3& point, const PlanningRequest& base);
/// Where the UAV is, or, on the ground, where it will be once it has taken off.
world::Vector3 in_the_air(const PlanningRequest& base);
/// Over the landing place.
world::Vector3 over_home(const PlanningRequest& base);

/// Ways of visiting what the task is about: the point of a place or location; of several places
/// every pair of them as entry and exit; of a zone without a place the corners where a sweep may
/// begin. Empty: it has no place, or one that nobody knows. Cost: of a zone, a sweep each corner.
std::vector<refiners::Gate> gates_of(const mission::HighLevelTask& goal,
                                     const PlanningRequest& base);

/// True of what is done with other UAVs: synchronisations and joint tasks. Who waits for a partner
/// in one of them while the partner waits in another waits for ever.
bool is_shared(const mission::HighLevelTask& goal, const mission::Vocabulary& vocabulary);

}  // namespace skein::supervisor
