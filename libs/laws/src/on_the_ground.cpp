// SPDX-License-Identifier: Apache-2.0
// Vehicles that keep to the ground.
#include <cmath>

#include "checks.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::laws {

namespace {

constexpr double kOn = 0.5;  // [m] of a sample from the ground, which is told a step later

/// Where it is and all around, as far as it may be from where it means to be: its way may lead
/// along the edge of what it can climb.
bool too_steep(const world::Terrain& terrain, const world::Vector3& at, double steepest,
               double off) {
  for (const double x : {0.0, -off, off})
    for (const double y : {0.0, -off, off})
      if (terrain.slope(at.x() + x, at.y() + y) <= steepest) return false;
  return true;
}

bool has_steeper(const world::Terrain& terrain, double slope) {
  const world::TerrainSpec& spec = terrain.spec();
  const double step = spec.cell / 4;
  for (double x = spec.west; x <= spec.east; x += step)
    for (double y = spec.south; y <= spec.north; y += step)
      if (terrain.slope(x, y) > slope) return true;
  return false;
}

}  // namespace

std::vector<Violation> off_its_ground(const History& history) {
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    const auto& ground = uav.spec->model.ground;
    if (!ground) continue;
    const double off = 3 * world::tracking_spread(uav.spec->model);
    bool was_on_good = false;  // it may be put on ground that is too steep, and drives off
    for (const Sample& sample : uav.samples) {
      const world::Vector3& at = sample.position;
      const double height = at.z() - history.terrain.elevation(at.x(), at.y());
      const bool steep = too_steep(history.terrain, at, ground->steepest, off);
      const char* what = sample.airborne          ? "is in the air"
                         : std::abs(height) > kOn ? "is not on the ground"
                         : steep && was_on_good   ? "drives over ground too steep for it"
                                                  : nullptr;
      was_on_good = was_on_good || !steep;
      if (what == nullptr) continue;
      result.push_back({"", sample.at, name, 0,
                        std::string(what) + " at (" + figure(at.x()) + " " + figure(at.y()) + ")"});
      break;
    }
  }
  return result;
}

bool climbs_everything(const History& history, const world::VehicleModel& vehicle) {
  return !vehicle.ground || !has_steeper(history.terrain, vehicle.ground->steepest);
}

bool rises_everywhere(const History& history, const world::VehicleModel& vehicle) {
  const double steepest = std::atan2(vehicle.climb_rate, vehicle.cruise_speed);
  return vehicle.ground || !has_steeper(history.terrain, steepest);
}

}  // namespace skein::laws
