// SPDX-License-Identifier: Apache-2.0
#include "energy_left.hpp"

#include <algorithm>

namespace skein::laws {

namespace {

/// The share of its energy that going home and landing takes, with half as much again.
double share_to_land(const History& history, const Uav& uav, const Sample& sample) {
  const world::VehicleModel& model = uav.spec->model;
  const world::Wind& wind = history.scenario->world.wind;
  const double speed =
      std::max(1.0, model.cruise_speed - model.wind_drift * (wind.speed + 2 * wind.gusts));
  const double home = (sample.position.head<2>() - uav.spec->start).norm();
  const double ground = history.terrain.elevation(uav.spec->start.x(), uav.spec->start.y());
  const double descent = std::max(0.0, sample.position.z() - ground) / model.descent_rate;
  const double joules =
      home / speed * std::max(model.energy.cruise_power, model.energy.hover_power) +
      (20 + 1.5 * descent) * model.energy.hover_power;
  return 1.5 * joules / model.energy.capacity;
}

}  // namespace

bool lacks_energy_to_land(const History& history, const Uav& uav, const Sample& sample) {
  return sample.energy < uav.spec->model.energy.reserve + share_to_land(history, uav, sample);
}

}  // namespace skein::laws
