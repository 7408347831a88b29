// SPDX-License-Identifier: Apache-2.0
// Which pairs of nodes can talk, how well.
#pragma once

#include "skein/foundation/time.hpp"
#include "skein/world/terrain.hpp"

namespace skein::world {

/// The state of the radio between two places, in one direction.
struct RadioLink {
  bool up = false;
  Duration latency;  ///< one way; zero when down
  double loss = 0;   ///< fraction of samples that never arrive, [0, 1]; 1 when down
  bool operator==(const RadioLink&) const = default;
};

/// One radio for all nodes of a scenario. Source: spec 1.3 (channels), 8.1.
struct RadioModel {
  double range = 0;                 ///< [m], > 0
  bool needs_line_of_sight = true;  ///< terrain between two nodes cuts them
  Duration latency;
  double loss = 0;  ///< [0, 1)
  /// A link that is up holds until this much beyond the range, as a fraction of it, so that a
  /// vehicle on the limit does not cut and restore it at every step.
  double hysteresis = 0.05;
  bool operator==(const RadioModel&) const = default;

  /// Symmetrical in a and b [m, ENU]. `was_up`: what it was when last asked.
  RadioLink link(const Vector3& a, const Vector3& b, const Terrain& terrain, bool was_up) const;
};

}  // namespace skein::world
