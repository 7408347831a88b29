// SPDX-License-Identifier: Apache-2.0
// Where a straight leg is inside an upright prism; private.
#pragma once

#include <optional>
#include <vector>

#include "skein/world/volume.hpp"

namespace skein::refiners {

/// Part of a leg, in fractions of it.
struct LegPart {
  double from = 0, until = 1;
};

/// The parts inside the volume, in order, whatever the time; touching its outside in a point, or
/// along its floor or ceiling, is not inside. Cost: O(k log k), where k is its number of corners.
std::vector<LegPart> parts_inside(const world::Volume& volume, const world::Vector3& from,
                                  const world::Vector3& to);

/// When a leg may be flown: its beginning and what it takes, each between bounds.
struct LegTimes {
  MissionTime earliest, latest;  ///< it begins
  Duration least, most;          ///< it takes
};

/// The first fraction of the part at which it may be flown while the window is open.
std::optional<double> first_within(const LegPart& part, const LegTimes& times,
                                   const world::TimeWindow& window);

}  // namespace skein::refiners
