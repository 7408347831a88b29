// SPDX-License-Identifier: Apache-2.0
// Which UAVs have what the tasks of a global mission need.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "skein/team/conflicts.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::team {

/// By UAV.
using Vehicles = std::map<std::string, world::VehicleModel>;

/// The tasks for which too few UAVs of the roster have what is needed, with what each of them
/// lacks; who is forbidden or left out by a pin to another counts as one that cannot. Batteries
/// count as full. Cost: tasks × vehicles.
std::vector<Conflict> lacks_of(const GlobalMission& mission, const Roster& roster,
                               const Vehicles& vehicles);

}  // namespace skein::team
