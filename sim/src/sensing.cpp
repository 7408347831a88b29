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

/// Of a fire front so many places are looked at.
constexpr std::size_t kPlacesOfFront = 48;

/// What of an object is seen as one thing: all of it, or a place of a fire front.
struct Part {
  Vector3 centre = Vector3::Zero();
  double radius = 0;
};

bool is_visible(const world::View& view, const Part& part, const world::Terrain& terrain) {
  if (!world::in_view(view, part.centre, part.radius)) return false;
  const double ground = terrain.elevation(part.centre.x(), part.centre.y());
  const double top = std::max(part.centre.z(), ground + kLeastTop);
  return terrain.line_of_sight(view.viewpoint, Vector3(part.centre.x(), part.centre.y(), top));
}

/// Of the angle between where it looks and where a place is; 1: it looks there.
double cosine_off_axis(const world::View& view, const Vector3& place) {
  const Vector3 way = place - view.viewpoint;
  const double distance = way.norm();
  return distance > 0 ? way.dot(view.direction) / distance : 1;
}

std::optional<Part> visible_front(const world::View& view, const world::WorldObject& object,
                                  MissionTime at, const world::Terrain& terrain) {
  std::optional<Part> seen;
  for (const world::Vector2& place : world::front_of(object, at).outline(kPlacesOfFront)) {
    if (!terrain.contains(place.x(), place.y())) continue;
    const double ground = terrain.elevation(place.x(), place.y());
    const Part part{{place.x(), place.y(), ground + object.height}, 0};
    const bool nearer =
        !seen || cosine_off_axis(view, part.centre) > cosine_off_axis(view, seen->centre);
    if (nearer && is_visible(view, part, terrain)) seen = part;
  }
  return seen;
}

Part whole(const world::WorldObject& object, MissionTime at, const world::Terrain& terrain) {
  return {world::position_at(object, at, terrain), object.radius};
}

std::optional<Part> visible_part(const world::View& view, const world::WorldObject& object,
                                 MissionTime at, const world::Terrain& terrain) {
  if (!world::is_active(object, at)) return std::nullopt;
  if (object.spread) return visible_front(view, object, at, terrain);
  const Part all = whole(object, at, terrain);
  return is_visible(view, all, terrain) ? std::optional(all) : std::nullopt;
}

double quality_of(const world::SensorModel& sensor, const Vector3& viewpoint, const Part& part,
                  bool lies, const world::Terrain& terrain) {
  const Vector3 offset = viewpoint - part.centre;
  const double distance = offset.norm();
  if (distance <= part.radius) return 1;
  const Vector3 normal = lies ? world::ground_normal(terrain, part.centre.x(), part.centre.y())
                              : Vector3(Vector3::UnitZ());
  // What is in view is within range, whatever rounding says.
  const double nearest = std::min(distance - part.radius, sensor.range);
  return world::distance_quality(sensor, nearest) *
         world::incidence_quality(sensor, offset.dot(normal) / distance);
}

}  // namespace

bool is_visible(const world::View& view, const world::WorldObject& object, MissionTime at,
                const world::Terrain& terrain) {
  return visible_part(view, object, at, terrain).has_value();
}

double quality_of(const world::SensorModel& sensor, const Vector3& viewpoint,
                  const world::WorldObject& object, MissionTime at, const world::Terrain& terrain) {
  return quality_of(sensor, viewpoint, whole(object, at, terrain), object.height <= 0, terrain);
}

std::vector<world::Detection> look(const world::SensorModel& sensor, const world::View& view,
                                   const Scene& scene, MissionTime at, Random& random) {
  std::vector<world::Detection> detections;
  for (const world::WorldObject& object : scene.objects) {
    const auto response = sensor.responses.find(object.kind);
    if (response == sensor.responses.end()) continue;
    const auto part = visible_part(view, object, at, scene.terrain);
    if (!part) continue;
    const double quality =
        quality_of(sensor, view.viewpoint, *part, object.height <= 0, scene.terrain);
    if (!random.chance(response->second.probability * quality)) continue;
    detections.push_back({response->second.reported_as,
                          scattered(part->centre, sensor.position_spread, random),
                          sensor.position_spread, response->second.confidence});
  }
  const double mean = sensor.false_alarm_rate * sensor.period.to_seconds();
  for (int left = mean > 0 ? poisson(mean, random) : 0; left > 0; --left)
    detections.push_back({sensor.false_alarm_kind, imagined_place(view, scene.terrain, random),
                          sensor.position_spread, sensor.false_alarm_confidence});
  return detections;
}

}  // namespace skein::sim
