// SPDX-License-Identifier: Apache-2.0
#include "skein/world/radio_model.hpp"

namespace skein::world {

RadioLink RadioModel::link(const Vector3& a, const Vector3& b, const Terrain& terrain,
                           bool was_up) const {
  const double limit = was_up ? range * (1 + hysteresis) : range;
  const bool heard =
      (a - b).norm() <= limit && (!needs_line_of_sight || terrain.line_of_sight(a, b));
  if (!heard) return {false, Duration(), 1};
  return {true, latency, loss};
}

}  // namespace skein::world
