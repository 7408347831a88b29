// SPDX-License-Identifier: Apache-2.0
// Area sharing over any area, from anywhere.
#pragma once

#include <cstdint>

#include "skein/refiners/partition.hpp"
#include "skein/scenario/scenario.hpp"
#include "skein/supervisor/area_sweep.hpp"

namespace skein::testing {

/// scenarios/area-sharing/negotiated.yaml with a convex area of 1 to 2.2 km² drawn by the seed, and
/// its three helicopters on the ground in or around it. Level ground, calm air.
scenario::Scenario drawn_area(std::uint64_t seed);
/// The same area and helicopters in scenarios/area-sharing/central.yaml, divided as `skein refine`
/// does it.
scenario::Scenario drawn_central_area(std::uint64_t seed);

/// The partition that partition.json asks `skein refine` for, from what the scenario says; or, for
/// parts that are shared, as the UAVs reckon it where they stand.
refiners::Partition divided(const scenario::Scenario& scenario, refiners::ShareMode mode,
                            supervisor::Sweeping sweeping = supervisor::Sweeping::kOwn);

}  // namespace skein::testing
