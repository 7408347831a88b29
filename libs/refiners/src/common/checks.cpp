// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/checks.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "common/shared_checks.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/world/polygon_check.hpp"

namespace skein::refiners {
std::optional<Refusal> check_finite(const world::Vector3& point, const std::string& field) {
  if (point.allFinite()) return std::nullopt;
  return bad(field, "every coordinate must be a finite number");
}

std::optional<Refusal> check_positive(double value, const std::string& field) {
  if (std::isfinite(value) && value > 0) return std::nullopt;
  return bad(field, figure(value) + " is not a positive, finite number");
}

std::optional<Refusal> check_vehicle(const world::VehicleModel& vehicle) {
  for (const auto& [value, field] : {std::pair{vehicle.cruise_speed, "vehicle.speed.cruise"},
                                     std::pair{vehicle.max_speed, "vehicle.speed.max"},
                                     std::pair{vehicle.climb_rate, "vehicle.climb_rate"},
                                     std::pair{vehicle.descent_rate, "vehicle.descent_rate"},
                                     std::pair{vehicle.acceleration, "vehicle.acceleration"},
                                     std::pair{vehicle.energy.capacity, "vehicle.energy.capacity"}})
    if (auto problem = check_positive(value, field)) return problem;
  if (!vehicle.ground)
    if (auto problem = check_positive(vehicle.ceiling, "vehicle.ceiling")) return problem;
  if (vehicle.cruise_speed > vehicle.max_speed)
    return bad("vehicle.speed.cruise", figure(vehicle.cruise_speed) + " m/s is more than max, " +
                                           figure(vehicle.max_speed) + " m/s");
  if (!(vehicle.min_speed >= 0 && vehicle.min_speed <= vehicle.cruise_speed))
    return bad("vehicle.speed.min", figure(vehicle.min_speed) + " m/s is not between 0 and cruise");
  if (!vehicle.hovers) return check_positive(vehicle.min_turn_radius, "vehicle.min_turn_radius");
  return check_positive(vehicle.yaw_rate, "vehicle.yaw_rate");
}

std::optional<Refusal> check_polygon(const world::Polygon& polygon, const std::string& field) {
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (!polygon[i].allFinite())
      return bad(field + "." + std::to_string(i), "every coordinate must be a finite number");
  if (auto problem = world::problem_of(polygon)) return bad(field, std::move(*problem));
  return std::nullopt;
}

Result<const world::SensorModel*, Refusal> sensor_of(const world::VehicleModel& vehicle,
                                                     const std::string& device) {
  if (const auto* found = world::find_sensor(vehicle, device)) return found;
  std::vector<std::string> devices;
  std::string list;
  for (const world::SensorModel& sensor : vehicle.sensors) {
    devices.push_back(sensor.device);
    list += (list.empty() ? "" : ", ") + sensor.device;
  }
  std::string why =
      "the vehicle has no sensor '" + device + "'; it has " + (list.empty() ? "none" : list);
  why += did_you_mean(nearest_name(device, devices));
  return refuse(RefusalKind::kBeyondVehicle, "device", std::move(why));
}

}  // namespace skein::refiners
