// SPDX-License-Identifier: Apache-2.0
#include "skein/world/passage.hpp"

#include <algorithm>
#include <cmath>

#include "skein/world/steering.hpp"

namespace skein::world {

Passage passage_of(const Vector3& before, const Vector3& at, const Vector3& behind, double speed) {
  if ((at - before).norm() <= 0 || (behind - at).norm() <= 0) return {};
  const Vector3 in = (at - before).normalized(), out = (behind - at).normalized();
  Passage passage{speed * (1 + in.dot(out)) / 2, 0};
  const double slope = std::min(std::abs(in.z()), std::abs(out.z()));
  if (in.z() * out.z() > 0) passage.climb = passage.speed * std::copysign(slope, out.z());
  return passage;
}

double stopping_speed(double acceleration, double distance) {
  return std::min(std::sqrt(acceleration * distance), kPositionGain * distance);
}

}  // namespace skein::world
