// SPDX-License-Identifier: Apache-2.0
// One overload per kind of target.
#include "skein/ground_station/target_resolution.hpp"

#include <algorithm>
#include <cmath>

#include "skein/ground_station/pattern.hpp"

namespace skein::ground_station {
namespace {

using world::Vector2;
using world::Vector3;
using Points = Result<std::vector<Vector3>, Failure>;

constexpr double kGroundStep = 10;  // [m] between two looks at the ground under a leg
constexpr double kMostGroundSteps = 10'000;

Points where(const AtPoints& target, const Alarm*, const world::Terrain&) {
  if (target.points.empty()) return failure("no points");
  return target.points;
}

Points where(const NearAlarm& target, const Alarm* subject, const world::Terrain& terrain) {
  if (subject == nullptr) return failure("there is no alarm to be near to");
  const Vector2 offset(std::cos(target.bearing), std::sin(target.bearing));
  const Vector2 at = subject->position.head<2>() + target.distance * offset;
  return std::vector<Vector3>{
      {at.x(), at.y(), terrain.elevation(at.x(), at.y()) + target.altitude}};
}

double highest_ground(const Vector2& from, const Vector2& to, const world::Terrain& terrain) {
  const double wanted = std::ceil((to - from).norm() / kGroundStep);
  const int steps = static_cast<int>(std::clamp(wanted, 1.0, kMostGroundSteps));
  double highest = terrain.elevation(from.x(), from.y());
  for (int i = 1; i <= steps; ++i) {
    const Vector2 at = from + static_cast<double>(i) / steps * (to - from);
    highest = std::max(highest, terrain.elevation(at.x(), at.y()));
  }
  return highest;
}

Points where(const OverZone& target, const Alarm* subject, const world::Terrain& terrain) {
  std::optional<Vector2> start;
  if (target.around_alarm) {
    if (subject == nullptr) return failure("there is no alarm to begin at");
    start = subject->position.head<2>();
  }
  const std::vector<Vector2> way = boustrophedon(target.zone, target.spacing, start);
  if (way.empty()) return failure("the zone has no area, or the spacing does not suit it");
  std::vector<double> ground;  // highest under each stretch of the way: leg, transit, leg, …
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    ground.push_back(highest_ground(way[i], way[i + 1], terrain));
  }
  std::vector<Vector3> points;
  for (std::size_t leg = 0; leg < ground.size(); leg += 2) {
    const auto first = ground.begin() + static_cast<std::ptrdiff_t>(leg > 0 ? leg - 1 : leg);
    const auto last =
        ground.begin() + static_cast<std::ptrdiff_t>(std::min(leg + 2, ground.size()));
    const double z = *std::max_element(first, last) + target.altitude;
    points.emplace_back(way[leg].x(), way[leg].y(), z);
    points.emplace_back(way[leg + 1].x(), way[leg + 1].y(), z);
  }
  return points;
}

Points where(const TheAlarm&, const Alarm* subject, const world::Terrain&) {
  if (subject == nullptr) return failure("there is no alarm");
  return std::vector<Vector3>{subject->position};
}

}  // namespace

Points resolve(const Target& target, const Alarm* subject, const world::Terrain& terrain) {
  Points points =
      std::visit([&](const auto& it) { return where(it, subject, terrain); }, target.where);
  if (!points) return points;
  const bool finite =
      std::all_of(points->begin(), points->end(), [](const Vector3& p) { return p.allFinite(); });
  if (!finite) return failure("a figure is not finite");
  return points;
}

}  // namespace skein::ground_station
