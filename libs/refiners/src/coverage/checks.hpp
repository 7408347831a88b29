// SPDX-License-Identifier: Apache-2.0
// What is wrong with a coverage query, and what stands in the way of a sweep.
#pragma once

#include <optional>
#include <vector>

#include "skein/refiners/coverage.hpp"

namespace skein::refiners {

/// Most lanes that are planned, so that a wrong swath cannot exhaust memory.
inline constexpr double kMostLanes = 100'000;

/// The first fault of the query, if any.
std::optional<Refusal> check_coverage(const CoverageQuery& query, const world::World& world);

/// The volumes that hold from `depart` on.
std::vector<const world::Volume*> volumes_from(const world::World& world, MissionTime depart);

/// True when the inside of the volume holds more than a point of the segment; touching is not in.
bool enters(const world::Vector3& from, const world::Vector3& to, const world::Volume& volume);

}  // namespace skein::refiners
