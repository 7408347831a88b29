// SPDX-License-Identifier: Apache-2.0
#include "flight/flights_met.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "flight/closed_air.hpp"

namespace skein::supervisor {

namespace {

constexpr int kAround = 8;

using IsMet = std::function<bool(const world::Vector3& at)>;

/// Of flights from these poses, each also so often with errors and gusts, and of the circles at
/// their ends.
bool some_meets(const IsMet& is_met, const refiners::Way& way, const world::VehicleModel& vehicle,
                const world::Wind& wind, std::uint64_t shaken, const std::vector<Pose>& poses) {
  const auto any_met = [&](const std::vector<world::Vector3>& track) {
    return std::any_of(track.begin(), track.end(), is_met);
  };
  const refiners::Way rest(way.begin() + 1, way.end());
  const double round = 2 * std::numbers::pi * vehicle.orbit_radius / vehicle.cruise_speed;
  for (const Pose& pose : poses) {
    if (is_met(pose.at)) continue;
    for (std::uint64_t trial = 1; trial <= shaken; ++trial)
      if (any_met(fly_way(pose, rest, vehicle, wind, trial).track)) return true;
    const FlownWay flown = fly_way(pose, rest, vehicle, wind);
    if (any_met(flown.track)) return true;
    if (vehicle.hovers) continue;
    if (any_met(circle_over(flown.end, way.back(), vehicle, wind, 2 * round))) return true;
  }
  return false;
}

/// Of a flight that climbs and sinks as late and as early as it may, and turns at each end of a
/// leg.
bool comes_near_ground(const refiners::Way& way, const world::Terrain& terrain, double least,
                       double beside) {
  const double step = terrain.spec().cell;
  const auto is_near_ground = [&](const world::Vector2& at, double height) {
    double highest = terrain.elevation(at.x(), at.y());
    for (int i = 0; i < 2 * kAround; ++i) {
      const double angle = 2 * std::numbers::pi * i / kAround,
                   out = i < kAround ? beside : beside / 2;
      highest = std::max(highest, terrain.elevation(at.x() + out * std::cos(angle),
                                                    at.y() + out * std::sin(angle)));
    }
    return height < highest + least;
  };
  for (std::size_t i = 1; i < way.size(); ++i) {
    const world::Vector3 leg = way[i] - way[i - 1];
    const double height = std::min(way[i - 1].z(), way[i].z());
    if (height >= terrain.highest() + least) continue;
    const int steps = 1 + static_cast<int>(leg.head<2>().norm() / step);
    for (int at = 0; at <= steps; ++at)
      if (is_near_ground((way[i - 1] + leg * at / steps).head<2>(), height)) return true;
  }
  return false;
}

}  // namespace

bool flights_meet(const refiners::Way& way, const std::vector<world::Volume>& volumes,
                  const world::VehicleModel& vehicle, const world::Wind& wind,
                  const Closeness& closeness) {
  return way.size() > 1 &&
         flights_meet(way, volumes, vehicle, wind, closeness, poses_at(way.front(), vehicle));
}

bool flights_meet(const refiners::Way& way, const std::vector<world::Volume>& volumes,
                  const world::VehicleModel& vehicle, const world::Wind& wind,
                  const Closeness& closeness, const std::vector<Pose>& poses) {
  if (way.size() < 2) return false;
  const auto is_met = [&](const world::Vector3& at) {
    return std::any_of(volumes.begin(), volumes.end(),
                       [&](const auto& volume) { return is_near(volume, at, closeness.margin); });
  };
  const std::uint64_t shaken = vehicle.hovers ? closeness.shaken : 0;
  return some_meets(is_met, way, vehicle, wind, shaken, poses);
}

bool flights_meet_ground(const refiners::Way& way, const world::Terrain& terrain,
                         const Closeness& closeness, const world::VehicleModel& vehicle,
                         const world::Wind& wind, const std::vector<Pose>& poses) {
  const bool level = terrain.highest() <= terrain.lowest();
  if (way.size() < 2 || level ||
      !comes_near_ground(way, terrain, closeness.margin, closeness.beside))
    return false;
  const auto is_met = [&](const world::Vector3& at) {
    return at.z() < terrain.highest() + closeness.margin &&
           at.z() < terrain.elevation(at.x(), at.y()) + closeness.margin;
  };
  return some_meets(is_met, way, vehicle, wind, closeness.shaken, poses);
}

}  // namespace skein::supervisor
