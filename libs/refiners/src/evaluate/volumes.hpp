// SPDX-License-Identifier: Apache-2.0
// Intersections of a straight leg with an upright prism; private.
#pragma once

#include <optional>
#include <vector>

#include "skein/world/volume.hpp"

namespace skein::refiners {

/// Part of a leg, in fractions of it.
struct LegPart {
  double from = 0, until = 1;
};

/// The parts of the leg inside the volume, in order, regardless of time; contact in a point, or
/// along floor or ceiling, does not count. Cost: O(k log k) for k corners.
std::vector<LegPart> parts_inside(const world::Volume& volume, const world::Vector3& from,
                                  const world::Vector3& to);

/// Bounds on the start and the duration of a leg.
struct LegTimes {
  MissionTime earliest, latest;  ///< start
  Duration least, most;          ///< duration
};

/// The first fraction of the leg, within the part, that may be flown while the window is open.
std::optional<double> first_within(const LegPart& part, const LegTimes& times,
                                   const world::TimeWindow& window);

}  // namespace skein::refiners
