// SPDX-License-Identifier: Apache-2.0
// Makes names in joint tasks of a plan intelligible to partners.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "skein/mission/elementary_plan.hpp"
#include "skein/world/geometry.hpp"

namespace skein::supervisor {

/// Places of the world by name [m] ENU.
using Places = std::map<std::string, world::Vector3, std::less<>>;

/// In each joint task of the plan, restores the world's spelling of place names, and sets the
/// gathering; its members are the parameter that names UAVs of the team.
void know_partners(mission::ElementaryPlan& plan, const Places& places,
                   const std::vector<std::string>& team);

}  // namespace skein::supervisor
