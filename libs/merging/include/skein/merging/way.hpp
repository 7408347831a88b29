// SPDX-License-Identifier: Apache-2.0
// A way through the air as a row of pieces, left one by one.
#pragma once

#include <cstddef>
#include <vector>

#include "skein/merging/margins.hpp"
#include "skein/merging/volume.hpp"

namespace skein::merging {

/// Where a vehicle is that holds there.
Volume stay_at(const world::Vector3& place, const Margins& margins);
/// All air between two heights over a place: a takeoff, a landing.
Volume column(const world::Vector2& place, double low, double high, const Margins& margins);

/// A flight from point to point, which ends by staying at the last. A value.
class Way {
 public:
  Way() = default;
  /// At least two points, the first where it begins. Long pieces are cut, and get way-points in
  /// between where wind would carry it off.
  Way(const std::vector<world::Vector3>& points, const Margins& margins);

  /// Where its pieces begin, and its end.
  const std::vector<world::Vector3>& points() const { return points_; }
  /// For the vehicle; the first where it begins.
  const std::vector<world::Vector3>& way_points() const { return way_points_; }
  /// Of each piece, and at last where it stays. Reserved as one.
  const Volumes& volumes() const { return volumes_; }
  /// Takes note of where the vehicle is. True: it has left more of its way.
  bool passed(const world::Vector3& position);
  /// What it has not left: the piece that it flies, the one before, which it may be blown back to,
  /// and all after them. Whoever cannot hover keeps twice the width of its way behind, since it
  /// turns back to way-points that it missed.
  Volumes left() const;

 private:
  std::vector<world::Vector3> points_, way_points_;
  Volumes volumes_;
  bool hovers_ = true;
  double near_ = 0;
  std::size_t piece_ = 0;  ///< that it flies
};

}  // namespace skein::merging
