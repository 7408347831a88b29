// SPDX-License-Identifier: Apache-2.0
// The horizon profile along one azimuth: the steepest slope up to the ground, by distance.
#pragma once

#include <vector>

#include "skein/world/terrain.hpp"

namespace skein::world {

/// The ground in the vertical plane through a place along an azimuth. It is traced once, at the
/// cost of one line of sight; then each line of sight in that plane costs O(log cells). Exact for
/// the bilinear ground: agrees with Terrain::line_of_sight but for rounding. A value type.
class HorizonProfile {
 public:
  /// From `from`, along `azimuth` [rad, ENU], as far as `reach` [m, horizontally]. What is asked
  /// beyond it is answered as if the ground ended there. Preconditions: all finite, reach >= 0.
  HorizonProfile(const Terrain& terrain, const Vector3& from, double azimuth, double reach);

  /// The steepest slope, rise over run, at which ground stands up to that distance [m,
  /// horizontally]; -infinity without ground. Never falls with distance.
  double slope_until(double distance) const;
  /// True when the point at that horizontal distance, > 0, and ENU height [m] is seen from `from`.
  bool sees(double distance, double z) const {
    return z - height_ >= slope_until(distance) * distance;
  }

 private:
  /// The ground over one cell: height over `from`, at s beyond `begin`: height + (slope + bend s)
  /// s.
  struct Piece {
    double begin, end;
    double height, slope, bend;
    double steepest_before;
    double slope_to(double distance) const;
    double steepest_until(double distance) const;
  };

  double height_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace skein::world
