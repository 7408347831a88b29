// SPDX-License-Identifier: Apache-2.0
// Makes names in joint tasks of a plan intelligible to partners.
#pragma once

#include <string>
#include <vector>

#include "skein/mission/elementary_plan.hpp"
#include "skein/world/world.hpp"

namespace skein::supervisor {

/// In each joint task of the plan, restores the world's spelling of places and zones, and sets the
/// gathering; its members are the parameter that names UAVs of the team.
void know_partners(mission::ElementaryPlan& plan, const world::World& world,
                   const std::vector<std::string>& team);

}  // namespace skein::supervisor
