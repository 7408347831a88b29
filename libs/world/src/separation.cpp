// SPDX-License-Identifier: Apache-2.0
#include "skein/world/separation.hpp"

#include <algorithm>
#include <cmath>

namespace skein::world {

namespace {
constexpr double kDownwash = 1;  // [m]
}

Separation separation_share(const VehicleModel& model) {
  const double spread = tracking_spread(model);
  return {model.body_radius + 2 * spread, model.body_radius + spread + kDownwash};
}

double kept_share(const Separation& both, const Vector3& one, const Vector3& other) {
  const Vector3 apart = one - other;
  return std::max(apart.head<2>().norm() / both.level, std::abs(apart.z()) / both.height);
}

}  // namespace skein::world
