// SPDX-License-Identifier: Apache-2.0
// The separation between two vehicles in flight.
#pragma once

#include "skein/world/geometry.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::world {

/// One vehicle's share of a separation. Two vehicles keep the sum of their shares, either
/// horizontally or vertically.
struct Separation {
  double level = 0;   ///< horizontal [m]
  double height = 0;  ///< vertical [m]

  bool operator==(const Separation&) const = default;
  Separation operator+(const Separation& other) const {
    return {level + other.level, height + other.height};
  }
};

/// Horizontally: half of the vehicle's size and two standard deviations of its position around the
/// intended one. Vertically one deviation, since barometer and eye hold height better, and a metre
/// for the downwash.
/// Source: 2 × (position error + tracking error + half size), ../shared/notes/team.md section 6;
/// without the age of positions, since whoever reserves air asks for no positions of others.
Separation separation_share(const VehicleModel& model);

/// The distance between two places as a fraction of the separation `both`: 1 if it is just kept,
/// less if it is violated; the greater of the horizontal and the vertical fraction.
double kept_share(const Separation& both, const Vector3& one, const Vector3& other);

}  // namespace skein::world
