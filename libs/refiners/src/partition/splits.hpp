// SPDX-License-Identifier: Apache-2.0
// All cuts of a convex piece in two by a line, with matching area and anchors on either side.
#pragma once

#include <vector>

#include "partition/cut.hpp"

namespace skein::refiners::partition {

/// Anchors and areas to satisfy, constant through the whole division.
struct Claims {
  std::vector<Vector2> anchors;
  std::vector<double> shares;
  double scale = 1;         ///< size of the whole area [m]
  double rounding = 1e-11;  ///< of the size
  double between = 0.5;     ///< position of lines taken between two extreme ones, (0, 1)

  /// Distance of an anchor from its part that counts as rounding [m].
  double tolerance() const { return rounding * scale; }
  double snap() const { return 1e-13 * scale; }
  double sum(const std::vector<std::size_t>& who) const;
};

/// A convex piece and the claims to satisfy in it.
struct Piece {
  Polygon polygon;
  std::vector<std::size_t> who;  ///< indices of claims, ascending
};

struct Split {
  Piece below, above;
  double cost = 0;  ///< compactness: less is more compact
};

/// perimeter² / area: the less, the more compact.
double slenderness(const Polygon& polygon);

/// The lines for which the area below equals the sum of the claims of the anchors below (anchors on
/// the line count to either side), best first: all such lines through an anchor, so that one is
/// found exactly if any exists (a line can be turned with constant area until it meets an anchor),
/// and one line between any two of them with the same anchors below.
/// Cost: O(n (v + n) v) for n anchors and v corners.
std::vector<Split> splits_of(const Piece& piece, const Claims& claims);

}  // namespace skein::refiners::partition
