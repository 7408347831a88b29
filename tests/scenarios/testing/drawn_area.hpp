// SPDX-License-Identifier: Apache-2.0
// Area sharing over any area, from anywhere.
#pragma once

#include <cstdint>

#include "skein/scenario/scenario.hpp"

namespace skein::testing {

/// scenarios/area-sharing/negotiated.yaml with a convex area of 1 to 2.2 km² drawn by the seed, and
/// its three helicopters on the ground in or around it. Level ground, calm air.
scenario::Scenario drawn_area(std::uint64_t seed);

}  // namespace skein::testing
