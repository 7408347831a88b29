// SPDX-License-Identifier: Apache-2.0
// Every way to cut a convex piece in two by a line, with the right area and the right anchors on
// either side.
#pragma once

#include <vector>

#include "partition/cut.hpp"

namespace skein::refiners::partition {

/// What is to be shared out, the same through the whole division.
struct Claims {
  std::vector<Vector2> anchors;
  std::vector<double> shares;
  double scale = 1;         ///< size of the whole area [m]
  double rounding = 1e-11;  ///< of the size
  double between = 0.5;     ///< which lines between two are taken, (0, 1)

  /// How far from its part an anchor may be by rounding [m].
  double tolerance() const { return rounding * scale; }
  double snap() const { return 1e-13 * scale; }
  double sum(const std::vector<std::size_t>& who) const;
};

/// A convex piece and who has to find room in it.
struct Piece {
  Polygon polygon;
  std::vector<std::size_t> who;  ///< indices of claims, ascending
};

struct Split {
  Piece below, above;
  double cost = 0;  ///< less is more compact
};

/// How far from round parts are, the less the better: perimeter² / area.
double slenderness(const Polygon& polygon);

/// The lines that have, below them, anchors (on them counts as either side) whose claims are
/// together the area below. All of those that pass through an anchor, so that there is one exactly
/// when any exists: a line can be turned, the area below it kept, until it meets an anchor; and one
/// between any two such with the same anchors below. The best first.
/// Cost: O(n (v + n) v) for n anchors and v corners.
std::vector<Split> splits_of(const Piece& piece, const Claims& claims);

}  // namespace skein::refiners::partition
