// SPDX-License-Identifier: Apache-2.0
#include "skein/world/vehicle_model.hpp"

#include <algorithm>
#include <cmath>

#include "skein/foundation/contract.hpp"

namespace skein::world {

std::string_view to_text(VehicleKind kind) {
  switch (kind) {
    case VehicleKind::kHelicopter:
      return "helicopter";
    case VehicleKind::kBlimp:
      return "blimp";
    case VehicleKind::kFixedWing:
      return "fixed-wing";
    case VehicleKind::kGround:
      return "ground";
  }
  SKEIN_ENSURES(false);
}

const SensorModel* find_sensor(const VehicleModel& model, std::string_view device) {
  const auto found = std::find_if(model.sensors.begin(), model.sensors.end(),
                                  [&](const SensorModel& s) { return s.device == device; });
  return found == model.sensors.end() ? nullptr : &*found;
}

Vector3 eye_of(const VehicleModel& model, const Vector3& position) {
  return model.ground ? Vector3(position + Vector3(0, 0, model.ground->mast)) : position;
}

double flight_power(const VehicleModel& model, double speed, double vertical_speed) {
  const EnergyModel& energy = model.energy;
  const double ratio = model.cruise_speed > 0 ? speed / model.cruise_speed : 0;
  const double level =
      energy.hover_power + (energy.cruise_power - energy.hover_power) * ratio * ratio;
  const double climb = model.climb_rate > 0
                           ? energy.climb_power * std::max(0.0, vertical_speed) / model.climb_rate
                           : 0;
  return std::max(energy.ground_power, level) + climb;
}

double tracking_spread(const VehicleModel& model) {
  return model.pilot ? std::hypot(model.position_precision, model.pilot->position_imprecision)
                     : model.position_precision;
}

}  // namespace skein::world
