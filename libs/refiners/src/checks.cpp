// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "skein/foundation/nearest.hpp"

namespace skein::refiners {
namespace {

using world::Polygon;
using world::Vector2;

std::string figure(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

Refusal bad(std::string field, std::string why) {
  return {RefusalKind::kBadQuery, std::move(field), std::move(why)};
}

double side_of(const Vector2& a, const Vector2& b, const Vector2& p) {
  const Vector2 along = b - a, offset = p - a;
  return along.x() * offset.y() - along.y() * offset.x();
}

bool within_box(const Vector2& a, const Vector2& b, const Vector2& p) {
  return p.x() >= std::min(a.x(), b.x()) && p.x() <= std::max(a.x(), b.x()) &&
         p.y() >= std::min(a.y(), b.y()) && p.y() <= std::max(a.y(), b.y());
}

/// Segments ab and cd have a point in common.
bool meet(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
  const double c_side = side_of(a, b, c), d_side = side_of(a, b, d);
  const double a_side = side_of(c, d, a), b_side = side_of(c, d, b);
  if (((c_side > 0 && d_side < 0) || (c_side < 0 && d_side > 0)) &&
      ((a_side > 0 && b_side < 0) || (a_side < 0 && b_side > 0)))
    return true;
  return (c_side == 0 && within_box(a, b, c)) || (d_side == 0 && within_box(a, b, d)) ||
         (a_side == 0 && within_box(c, d, a)) || (b_side == 0 && within_box(c, d, b));
}

/// Neighbours share a corner; they may not fold back on each other.
bool folds_back(const Vector2& a, const Vector2& corner, const Vector2& b) {
  return side_of(a, corner, b) == 0 && (a - corner).dot(b - corner) > 0;
}

std::optional<Refusal> check_edges(const Polygon& polygon, const std::string& field) {
  const std::size_t n = polygon.size();
  const auto corner = [&](std::size_t i) -> const Vector2& { return polygon[i % n]; };
  for (std::size_t i = 0; i < n; ++i)
    if (corner(i) == corner(i + 1))
      return bad(field, "corner " + std::to_string(i + 1) + " is there twice in a row");
  for (std::size_t i = 0; i < n; ++i) {
    if (folds_back(corner(i), corner(i + 1), corner(i + 2)))
      return bad(field, "the border folds back at corner " + std::to_string((i + 1) % n + 1));
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (meet(corner(i), corner(i + 1), corner(j), corner(j + 1)))
        return bad(field, "the edges after corners " + std::to_string(i + 1) + " and " +
                              std::to_string(j + 1) + " cross or touch");
    }
  }
  return std::nullopt;
}

}  // namespace

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
                                     std::pair{vehicle.ceiling, "vehicle.ceiling"},
                                     std::pair{vehicle.energy.capacity, "vehicle.energy.capacity"}})
    if (auto problem = check_positive(value, field)) return problem;
  if (vehicle.cruise_speed > vehicle.max_speed)
    return bad("vehicle.speed.cruise", figure(vehicle.cruise_speed) + " m/s is more than max, " +
                                           figure(vehicle.max_speed) + " m/s");
  if (!(vehicle.min_speed >= 0 && vehicle.min_speed <= vehicle.cruise_speed))
    return bad("vehicle.speed.min", figure(vehicle.min_speed) + " m/s is not between 0 and cruise");
  if (!vehicle.hovers) return check_positive(vehicle.min_turn_radius, "vehicle.min_turn_radius");
  return check_positive(vehicle.yaw_rate, "vehicle.yaw_rate");
}

std::optional<Refusal> check_polygon(const Polygon& polygon, const std::string& field) {
  if (polygon.size() < 3)
    return bad(field, std::to_string(polygon.size()) + " corners are not an area: at least three");
  if (polygon.size() > kMostCorners)
    return bad(field, std::to_string(polygon.size()) + " corners: at most " +
                          std::to_string(kMostCorners));
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (!polygon[i].allFinite())
      return bad(field + "." + std::to_string(i), "every coordinate must be a finite number");
  if (auto problem = check_edges(polygon, field)) return problem;
  if (!(world::area(polygon) > 0)) return bad(field, "the corners enclose no area");
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
  if (const std::string nearest = nearest_name(device, devices); !nearest.empty())
    why += "; did you mean '" + nearest + "'?";
  return refuse(RefusalKind::kBeyondVehicle, "device", std::move(why));
}

}  // namespace skein::refiners
