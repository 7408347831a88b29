// SPDX-License-Identifier: Apache-2.0
#include "skein/world/way_energy.hpp"

#include <algorithm>

namespace skein::world {

namespace {

constexpr double kTurningShare = 1.2;  // how much longer the way of one that cannot hover may be

}  // namespace

double energy_asked_for(const VehicleModel& model, Vector3 from, const std::vector<Vector3>& way,
                        double speed) {
  double energy = 0;
  for (const Vector3& to : way) {
    const double rise = to.z() - from.z();
    const double level_time = (to - from).head<2>().norm() / speed;
    const double climb_time = rise > 0 ? rise / model.climb_rate : -rise / model.descent_rate;
    energy += level_time * flight_power(model, speed, 0);
    energy += std::max(0.0, climb_time - level_time) * flight_power(model, 0, 0);
    if (rise > 0) energy += climb_time * model.energy.climb_power;
    from = to;
  }
  return model.hovers ? energy : energy * kTurningShare;
}

}  // namespace skein::world
