// SPDX-License-Identifier: Apache-2.0
#include "skein/world/steering.hpp"

namespace skein::world {

double reaching_distance(const VehicleModel& model, const Wind& wind) {
  const double displaced =
      model.hovers ? model.wind_drift * (wind.speed + 3 * wind.gusts) / kPositionGain : 0;
  return 1 + 3 * tracking_spread(model) + displaced;
}

double braking_distance(const VehicleModel& model, double speed) {
  return speed * speed / (2 * model.acceleration);
}

}  // namespace skein::world
