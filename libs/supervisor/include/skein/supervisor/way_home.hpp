// SPDX-License-Identifier: Apache-2.0
// The energy that a UAV needs in order to come home.
#pragma once

#include <vector>

#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Energy to fly home from a place in the air against the believed wind and to land there, plus the
/// margin that every plan keeps and the reserve. Fraction of the full capacity; 0 for a vehicle
/// whose model has no capacity. Cost: O(terrain cells on the way + volumes).
double least_to_come_home(const Knowledge& knowledge, const world::World& world, MissionTime now,
                          const world::Vector3& from);
/// The same along a way that begins where the vehicle is, and home from its end. Precondition: the
/// way has a point.
double least_to_come_home(const Knowledge& knowledge, const world::World& world, MissionTime now,
                          const std::vector<world::Vector3>& way);
/// Whether `energy` is at most least_to_come_home(). Cost: negligible while there is plenty.
bool must_come_home(double energy, const Knowledge& knowledge, const world::World& world,
                    MissionTime now, const std::vector<world::Vector3>& way);
bool must_come_home(double energy, const Knowledge& knowledge, const world::World& world,
                    MissionTime now, const world::Vector3& from);
/// Likewise with half of the margin, which is enough where hardly more is left than to come down.
bool must_land(double energy, const Knowledge& knowledge, const world::World& world,
               MissionTime now, const std::vector<world::Vector3>& way);

}  // namespace skein::supervisor
