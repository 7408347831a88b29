// SPDX-License-Identifier: Apache-2.0
// Reservations of air for paths (plan merging), from the event log. Source: spec 6.4.
#pragma once

#include <string>
#include <vector>

#include "skein/report/journal.hpp"
#include "story/chronology.hpp"

namespace skein::report {

/// The air within a radius of a line on the ground, between two heights [m].
struct AirPiece {
  GroundPoint from, to;
  double radius = 0, floor = 0, ceiling = 0;
};

/// A motion during which the state of its reservation does not change.
struct AirUse {
  std::size_t uav = 0;
  Span span;
  std::string state;  ///< waits, had, aside, unasked; ahead: beside what it flies
  std::string what;   ///< "7 goto"
  std::string why;    ///< the peers it waits for, or its additional height
  std::vector<AirPiece> pieces;
  bool ends_in_the_air = false;
};

/// In the order of the log; a wait with changed reasons is a further entry.
std::vector<AirUse> tell_air(const Journal& journal, const Chronology& story);

}  // namespace skein::report
