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

/// The angle of a chord that leaves an arc of that radius by `tolerance` [m], at most π/4 so that
/// an arc stays an arc [rad]. Precondition: both > 0.
double chord_angle(double radius, double tolerance);

/// Three pieces, each a turn left, a turn right or straight on; a piece may be empty. A value type.
/// Source: Dubins 1957.
class DubinsCurve {
 public:
  /// Precondition: radius > 0, all finite. Cost: constant. A turn that rounding alone would make a
  /// full one (within a billionth of a radian, or what the figures' own rounding amounts to) is
  /// none, so that a straight way stays straight.
  static DubinsCurve shortest(const Pose& from, const Pose& to, double radius);
  /// A full turn back to where it starts.
  static DubinsCurve circle(const Pose& from, double radius, bool left);

  double length() const { return lengths_[0] + lengths_[1] + lengths_[2]; }
  /// At a distance along it, held within [0, length()]; at the ends exactly the poses given.
  Pose at(double along) const;
  /// Points along it, both ends among them, such that no chord leaves the curve by more than
  /// `tolerance` [m], > 0. One point where the curve has no length.
  std::vector<world::Vector2> sampled(double tolerance) const;

 private:
  enum class Piece { kLeft, kStraight, kRight };
  struct Word;

  Pose advanced(const Pose& from, Piece piece, double length) const;

  Pose from_, to_;
  double radius_ = 1;
  std::array<Piece, 3> pieces_{};
  std::array<double, 3> lengths_{};  // [m]
};

}  // namespace skein::refiners
