// SPDX-License-Identifier: Apache-2.0
// How far apart two vehicles in the air must be.
#pragma once

#include "skein/world/geometry.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::world {

/// What one vehicle asks of the air around it; two keep the sum of theirs, level or in height.
struct Separation {
  double level = 0;   ///< [m]
  double height = 0;  ///< [m]

  bool operator==(const Separation&) const = default;
  Separation operator+(const Separation& other) const {
    return {level + other.level, height + other.height};
  }
};

/// Half of its size and two deviations of where it is around where it means to be; in height one
/// deviation, since barometer and eye hold it better, and a metre for the air that it pushes down.
/// Source: 2 × (position error + tracking error + half size), ../shared/notes/team.md section 6;
/// without the age of positions, since whoever reserves air asks for no positions of others.
Separation separation_share(const VehicleModel& model);

/// How much of the separation there is between two places: 1 where it is just kept, less where it
/// is not; the better of level and height.
double kept_share(const Separation& both, const Vector3& one, const Vector3& other);

}  // namespace skein::world
