// SPDX-License-Identifier: Apache-2.0
// What a UAV still has to hold in order to come home.
#pragma once

#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// To fly home from a place in the air against the wind as believed, and land there, with what
/// every plan leaves for the unforeseen and with the reserve. Fraction of what is held when full; 0
/// for a vehicle whose model has no capacity. Cost: O(terrain cells on the way + volumes).
double least_to_come_home(const Knowledge& knowledge, const world::World& world, MissionTime now,
                          const world::Vector3& from);
/// Whether so much is no more than that. Cost: next to nothing while there is plenty.
bool must_come_home(double energy, const Knowledge& knowledge, const world::World& world,
                    MissionTime now, const world::Vector3& from);

}  // namespace skein::supervisor
