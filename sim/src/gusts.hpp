// SPDX-License-Identifier: Apache-2.0
// The wind at one vehicle: the mean wind and the vehicle's own gusts.
#pragma once

#include "skein/foundation/random.hpp"
#include "skein/world/wind.hpp"

namespace skein::sim {

/// Each horizontal component of the gusts is a Gauss–Markov process: deviation as in the wind,
/// correlation time 5 s. Without gusts no random number is drawn.
class Gusts {
 public:
  Gusts(const world::Wind& wind, Random random);
  /// The motion of the air [m/s] for the next `dt` seconds.
  world::Vector3 next(double dt);

 private:
  world::Vector3 mean_;
  double deviation_;
  world::Vector2 gust_ = world::Vector2::Zero();
  Random random_;
};

}  // namespace skein::sim
