// SPDX-License-Identifier: Apache-2.0
// How vehicles that hover fly by way-points and come to rest, in the simulator and in thought.
#pragma once

#include "skein/world/geometry.hpp"

namespace skein::world {

/// How a way-point is flown by [m/s].
struct Passage {
  double speed = 0, climb = 0;
};

/// At `at`, from `before` and on to `behind`: stops where the way turns back, keeps its speed where
/// it goes straight on, and its climb on a slope.
Passage passage_of(const Vector3& before, const Vector3& at, const Vector3& behind, double speed);

/// The speed from which it can still stop in `distance` [m] with half its acceleration [m/s²].
double stopping_speed(double acceleration, double distance);

}  // namespace skein::world
