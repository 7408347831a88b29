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
  double rate = 0;  ///< speed of the head without wind [m/s], > 0
  double gain = 0;  ///< the head's speed-up per m/s of wind, as a fraction of `rate` [s/m], >= 0
  Wind wind = {};   ///< its gusts are ignored
  bool operator==(const FireSpread&) const = default;
};

/// The burning or burnt area at one instant: an ellipse with the ignition in its rear focus.
struct FireFront {
  Vector2 ignition = Vector2::Zero();  ///< [m]
  Vector2 ahead = Vector2::UnitX();    ///< of unit length: where its head moves
  double length = 0;                   ///< semi-major axis, along `ahead` [m], >= 0
  double breadth = 0;                  ///< semi-minor axis [m], from 0 to `length`
  bool operator==(const FireFront&) const = default;

  Vector2 centre() const;
  /// The point of the front that is farthest from the ignition.
  Vector2 head() const;
  bool contains(const Vector2& point) const;
  /// Distance from a point to the area [m]; 0 within.
  double distance_to(const Vector2& point) const;
  /// This many points of the ellipse, from the head on, counter-clockwise.
  std::vector<Vector2> outline(std::size_t points) const;
};

/// The front at `age` after its head was `radius` [m] ahead of its ignition. With uniform fuel and
/// wind the front is an ellipse of constant shape; its length-to-breadth ratio follows from the
/// wind (Anderson 1983, with 1 in calm air as in Finney), at most 8, and the rate of its rear from
/// that ratio. The area includes what has burnt out.
/// Cost: constant. Source: H. E. Anderson, Predicting wind-driven wild land fire size and shape,
/// INT-305, 1983; M. A. Finney, FARSITE, RMRS-RP-4, 1998.
FireFront front_of(const FireSpread& spread, const Vector2& ignition, double radius, Duration age);

/// The `age` (as in front_of(), so negative for earlier instants) at which the front reaches a
/// point; Duration::max(): never. Cost: constant.
Duration arrival_at(const FireSpread& spread, const Vector2& ignition, double radius,
                    const Vector2& point);

}  // namespace skein::world
