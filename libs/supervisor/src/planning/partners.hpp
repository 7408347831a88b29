// SPDX-License-Identifier: Apache-2.0
// What joint tasks of a plan name to partners.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "skein/mission/elementary_plan.hpp"
#include "skein/world/geometry.hpp"

namespace skein::supervisor {

/// As the world has them [m] ENU.
using Places = std::map<std::string, world::Vector3, std::less<>>;

/// Spells the places that joint tasks name as the world does, and says who gathers for each: the
/// members are the parameter that names UAVs of the team.
void know_partners(mission::ElementaryPlan& plan, const Places& places,
                   const std::vector<std::string>& team);

}  // namespace skein::supervisor
