// SPDX-License-Identifier: Apache-2.0
// Lower heights at which the places of a path may be passed.
#pragma once

#include <vector>

#include "flyable/leg.hpp"
#include "flyable/stations.hpp"
#include "skein/refiners/flyable.hpp"

namespace skein::refiners {

/// Adds stations below the first of each inner layer: at the highest floor between the neighbouring
/// layers, and at the least height over it from which the next high floor can be reached. Cost:
/// O(layers), nine questions to the floor each.
void add_lower_stations(std::vector<StationLayer>& layers, const FlightLimits& limits,
                        const Floor& floor);

}  // namespace skein::refiners
