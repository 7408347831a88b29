// SPDX-License-Identifier: Apache-2.0
// The shortest plane curve of bounded curvature between two poses.
#pragma once

#include <array>
#include <vector>

#include "skein/world/geometry.hpp"

namespace skein::refiners {

struct Pose {
  world::Vector2 at = world::Vector2::Zero();
  double heading = 0;  ///< [rad], ENU counter-clockwise from east
};

/// The central angle [rad] of a chord whose distance from its arc is `tolerance` [m], at most π/4.
/// Precondition: both > 0.
double chord_angle(double radius, double tolerance);

/// Three pieces, each a turn left, a turn right or straight on; a piece may be empty. A value type.
/// Source: Dubins 1957.
class DubinsCurve {
 public:
  /// Precondition: radius > 0, all finite. Cost: constant. A turn that is a full circle only by
  /// rounding (within 1e-9 rad, or the rounding of the figures) counts as none, so that a straight
  /// path stays straight.
  static DubinsCurve shortest(const Pose& from, const Pose& to, double radius);
  /// A full circle back to `from`.
  static DubinsCurve circle(const Pose& from, double radius, bool left);
  /// A turn by `angle` [rad], >= 0.
  static DubinsCurve arc(const Pose& from, double radius, bool left, double angle);

  double length() const { return lengths_[0] + lengths_[1] + lengths_[2]; }
  /// The pose at a distance along the curve, clamped to [0, length()]; at the ends exactly the
  /// given poses.
  Pose at(double along) const;
  /// Points along the curve including both ends, with chords no further than `tolerance` [m] (> 0)
  /// from the curve. A single point if the curve has no length.
  std::vector<world::Vector2> sampled(double tolerance) const;
  /// That of the chords between these points [m]. Cost: constant.
  double sampled_length(double tolerance) const;

 private:
  enum class Piece { kLeft, kStraight, kRight };
  struct Word;

  std::size_t chords_of(std::size_t piece, double tolerance) const;
  Pose advanced(const Pose& from, Piece piece, double length) const;

  Pose from_, to_;
  double radius_ = 1;
  std::array<Piece, 3> pieces_{};
  std::array<double, 3> lengths_{};  // [m]
};

}  // namespace skein::refiners
