// SPDX-License-Identifier: Apache-2.0
// Fires that spread: ellipses that grow with the wind.
#pragma once

#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/geometry.hpp"
#include "skein/world/wind.hpp"

namespace skein::world {

/// How a fire spreads over even ground with one fuel, in a steady wind.
struct FireSpread {
  double rate = 0;  ///< of its head without wind [m/s], > 0
  double gain = 0;  ///< each m/s of wind makes the head faster by this part of the rate [s/m], >= 0
  Wind wind = {};   ///< that it spreads in; gusts do not count
  bool operator==(const FireSpread&) const = default;
};

/// What burns, or has burnt, at one instant: an ellipse with the ignition in its rear focus.
struct FireFront {
  Vector2 ignition = Vector2::Zero();  ///< [m]
  Vector2 ahead = Vector2::UnitX();    ///< of unit length: where its head moves
  double length = 0;                   ///< half of it, along `ahead` [m], >= 0
  double breadth = 0;                  ///< half of it [m], from 0 to `length`
  bool operator==(const FireFront&) const = default;

  Vector2 centre() const;
  /// Where it is farthest from the ignition.
  Vector2 head() const;
  bool contains(const Vector2& point) const;
  /// How far a point is from what it contains; 0 within [m].
  double distance_to(const Vector2& point) const;
  /// So many points of it, from the head, counter-clockwise.
  std::vector<Vector2> outline(std::size_t points) const;
};

/// The fire when it has burnt for `age` since it reached `radius` ahead of its ignition. The same
/// fuel in the same wind all around burns as an ellipse that keeps its shape; the ratio of its
/// length to its breadth follows from the wind (Anderson 1983, with 1 in calm air as Finney has
/// it), at most 8, and the rate of its rear from that. What has burnt goes on to belong to it.
/// Cost: constant. Source: H. E. Anderson, Predicting wind-driven wild land fire size and shape,
/// INT-305, 1983; M. A. Finney, FARSITE, RMRS-RP-4, 1998.
FireFront front_of(const FireSpread& spread, const Vector2& ignition, double radius, Duration age);

/// When a point burns, counted as `age`; negative: before. Duration::max(): never. Cost: constant.
Duration arrival_at(const FireSpread& spread, const Vector2& ignition, double radius,
                    const Vector2& point);

}  // namespace skein::world
