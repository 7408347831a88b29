// SPDX-License-Identifier: Apache-2.0
// A piece of air between two levels over a polygon, for a time: a no-fly zone, a reservation.
#pragma once

#include <limits>
#include <string>

#include "skein/foundation/time.hpp"
#include "skein/world/geometry.hpp"

namespace skein::world {

/// [from, until): both in mission time.
struct TimeWindow {
  MissionTime from;
  MissionTime until = MissionTime::max();
  bool operator==(const TimeWindow&) const = default;

  bool overlaps(const TimeWindow& other) const { return from < other.until && other.from < until; }
};

/// An upright prism. Source: spec 4.1 (no-fly zones: polygon × altitude band, optional time
/// window).
struct Volume {
  std::string name;
  Polygon polygon;                                           ///< simple, [m] ENU
  double floor = -std::numeric_limits<double>::infinity();   ///< [m] ENU z
  double ceiling = std::numeric_limits<double>::infinity();  ///< [m] ENU z, > floor
  TimeWindow when;
  bool operator==(const Volume&) const = default;
};

}  // namespace skein::world
