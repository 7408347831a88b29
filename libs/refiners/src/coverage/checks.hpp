// SPDX-License-Identifier: Apache-2.0
// Checks of a coverage query, and intersections of a sweep with volumes.
#pragma once

#include <optional>
#include <vector>

#include "skein/refiners/coverage.hpp"

namespace skein::refiners {

/// Most lanes of a sweep, so that a wrong swath cannot exhaust memory.
inline constexpr double kMostLanes = 100'000;

/// The first fault of the query, if any.
std::optional<Refusal> check_coverage(const CoverageQuery& query, const world::World& world);

/// The volumes whose window ends after `depart`.
std::vector<const world::Volume*> volumes_from(const world::World& world, MissionTime depart);

/// Whether more than a point of the segment is inside the volume; contact does not count.
bool enters(const world::Vector3& from, const world::Vector3& to, const world::Volume& volume);

}  // namespace skein::refiners
