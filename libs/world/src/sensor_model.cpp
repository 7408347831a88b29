// SPDX-License-Identifier: Apache-2.0
#include "skein/world/sensor_model.hpp"

#include <algorithm>
#include <cmath>

namespace skein::world {

bool in_view(const View& view, const Vector3& centre, double radius) {
  const Vector3 offset = centre - view.viewpoint;
  const double distance = offset.norm();
  if (distance <= radius) return true;
  if (distance - radius > view.range) return false;
  const double off_axis = std::acos(std::clamp(offset.dot(view.direction) / distance, -1.0, 1.0));
  return off_axis - std::asin(radius / distance) <= view.aperture;
}

}  // namespace skein::world
