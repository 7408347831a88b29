// SPDX-License-Identifier: Apache-2.0
#include "sensing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "skein/world/ground_normal.hpp"

namespace skein::sim {
namespace {

using world::Vector3;

/// The least height at which an object shows above the ground, so that level ground never hides it
/// [m].
constexpr double kLeastTop = 0.5;
/// More false alarms in one look than any sensible rate gives.
constexpr int kMostFalseAlarms = 100;

Vector3 scattered(const Vector3& at, double spread, Random& random) {
  const double east = random.normal(), north = random.normal(), up = random.normal();
  return at + spread * Vector3(east, north, up);
}

/// A number of events of a Poisson process whose mean is `mean` (by counting in unit exponentials).
int poisson(double mean, Random& random) {
  int count = 0;
  for (double sum = -std::log(1 - random.uniform()); sum < mean && count < kMostFalseAlarms;
       sum -= std::log(1 - random.uniform()))
    ++count;
  return count;
}

/// Any vector at right angles to a unit vector, of unit length.
Vector3 perpendicular(const Vector3& direction) {
  const Vector3 other = std::abs(direction.z()) < 0.9 ? Vector3::UnitZ() : Vector3::UnitX();
  const Vector3 across(direction.y() * other.z() - direction.z() * other.y(),
                       direction.z() * other.x() - direction.x() * other.z(),
                       direction.x() * other.y() - direction.y() * other.x());
  return across.normalized();
}

/// Uniform over the solid angle of the cone.
Vector3 direction_within(const world::View& view, Random& random) {
  const double along = random.uniform(std::cos(view.aperture), 1);
  const double turn = random.uniform(0, 2 * std::numbers::pi);
  const Vector3 u = perpendicular(view.direction);
  const Vector3 v(view.direction.y() * u.z() - view.direction.z() * u.y(),
                  view.direction.z() * u.x() - view.direction.x() * u.z(),
                  view.direction.x() * u.y() - view.direction.y() * u.x());
  const double aside = std::sqrt(std::max(0.0, 1 - along * along));
  return along * view.direction + aside * (std::cos(turn) * u + std::sin(turn) * v);
}

Vector3 imagined_place(const world::View& view, const world::Terrain& terrain, Random& random) {
  const Vector3 ray = view.range * direction_within(view, random);
  const double reach = random.uniform();
  return view.viewpoint +
         terrain.first_hit(view.viewpoint, view.viewpoint + ray).value_or(reach) * ray;
}

}  // namespace

bool is_visible(const world::View& view, const world::WorldObject& object, MissionTime at,
                const world::Terrain& terrain) {
  if (!world::is_active(object, at)) return false;
  const Vector3 centre = world::position_at(object, at, terrain);
  if (!world::in_view(view, centre, object.radius)) return false;
  const double ground = terrain.elevation(centre.x(), centre.y());
  const double top = std::max(centre.z(), ground + kLeastTop);
  return terrain.line_of_sight(view.viewpoint, Vector3(centre.x(), centre.y(), top));
}

double quality_of(const world::SensorModel& sensor, const Vector3& viewpoint,
                  const world::WorldObject& object, MissionTime at, const world::Terrain& terrain) {
  const Vector3 centre = world::position_at(object, at, terrain);
  const Vector3 offset = viewpoint - centre;
  const double distance = offset.norm();
  if (distance <= object.radius) return 1;
  const Vector3 normal = object.height > 0 ? Vector3(Vector3::UnitZ())
                                           : world::ground_normal(terrain, centre.x(), centre.y());
  // What is in view is within range, whatever rounding says.
  const double nearest = std::min(distance - object.radius, sensor.range);
  return world::distance_quality(sensor, nearest) *
         world::incidence_quality(sensor, offset.dot(normal) / distance);
}

std::vector<world::Detection> look(const world::SensorModel& sensor, const world::View& view,
                                   const Scene& scene, MissionTime at, Random& random) {
  std::vector<world::Detection> detections;
  for (const world::WorldObject& object : scene.objects) {
    const auto response = sensor.responses.find(object.kind);
    if (response == sensor.responses.end() || !is_visible(view, object, at, scene.terrain))
      continue;
    const double quality = quality_of(sensor, view.viewpoint, object, at, scene.terrain);
    if (!random.chance(response->second.probability * quality)) continue;
    const Vector3 centre = world::position_at(object, at, scene.terrain);
    detections.push_back({response->second.reported_as,
                          scattered(centre, sensor.position_spread, random), sensor.position_spread,
                          response->second.confidence});
  }
  const double mean = sensor.false_alarm_rate * sensor.period.to_seconds();
  for (int left = mean > 0 ? poisson(mean, random) : 0; left > 0; --left)
    detections.push_back({sensor.false_alarm_kind, imagined_place(view, scene.terrain, random),
                          sensor.position_spread, sensor.false_alarm_confidence});
  return detections;
}

}  // namespace skein::sim
