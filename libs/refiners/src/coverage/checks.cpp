// SPDX-License-Identifier: Apache-2.0
#include "coverage/checks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "common/shared_checks.hpp"
#include "coverage/sweep_planner.hpp"
#include "skein/refiners/checks.hpp"

namespace skein::refiners {
namespace {

using world::Polygon;
using world::Vector2;
using world::Vector3;

constexpr double kTouch = 1e-6;  // [m]
/// Less of an area than that is what rounding leaves.
constexpr double kNothing = 1e-9;

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Where a segment meets the border, as fractions of it.
void add_cuts(const Vector2& from, const Vector2& to, const Polygon& polygon,
              std::vector<double>& cuts) {
  const Vector2 line = to - from;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 p = polygon[i] - from, q = polygon[(i + 1) % polygon.size()] - from;
    const double side_p = cross(line, p), side_q = cross(line, q);
    if ((side_p > 0 && side_q > 0) || (side_p < 0 && side_q < 0) || side_p == side_q) continue;
    const Vector2 meeting = p + (q - p) * (side_p / (side_p - side_q));
    const double part = meeting.dot(line) / line.squaredNorm();
    if (part > 0 && part < 1) cuts.push_back(part);
  }
}

double distance_to_border(const Vector2& point, const Polygon& polygon) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    const double length2 = edge.squaredNorm();
    const double part =
        length2 > 0 ? std::clamp((point - polygon[i]).dot(edge) / length2, 0.0, 1.0) : 0;
    least = std::min(least, (point - polygon[i] - part * edge).norm());
  }
  return least;
}

/// The border or the inside of a polygon holds some of the inside of a segment.
bool runs_inside(const Vector2& from, const Vector2& to, const Polygon& polygon) {
  std::vector<double> cuts{0, 1};
  if ((to - from).squaredNorm() > 0) add_cuts(from, to, polygon, cuts);
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Vector2 middle = from + (to - from) * (cuts[i] + cuts[i + 1]) / 2;
    if (world::contains(polygon, middle) && distance_to_border(middle, polygon) > kTouch)
      return true;
  }
  return false;
}

bool borders_cross(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector2 &p = a[i], &q = a[(i + 1) % a.size()];
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Vector2 &r = b[j], &s = b[(j + 1) % b.size()];
      const double sides[] = {cross(q - p, r - p), cross(q - p, s - p), cross(s - r, p - r),
                              cross(s - r, q - r)};
      if (((sides[0] > 0 && sides[1] < 0) || (sides[0] < 0 && sides[1] > 0)) &&
          ((sides[2] > 0 && sides[3] < 0) || (sides[2] < 0 && sides[3] > 0)))
        return true;
    }
  }
  return false;
}

bool all_in(const Polygon& inner, const Polygon& outer) {
  return std::all_of(inner.begin(), inner.end(),
                     [&](const Vector2& corner) { return world::contains(outer, corner); });
}

bool any_in(const Polygon& inner, const Polygon& outer) {
  return std::any_of(inner.begin(), inner.end(),
                     [&](const Vector2& corner) { return world::contains(outer, corner); });
}

std::optional<Refusal> check_holes(const CoverageQuery& query) {
  for (std::size_t i = 0; i < query.holes.size(); ++i) {
    const std::string field = "holes." + std::to_string(i);
    if (auto problem = check_polygon(query.holes[i], field)) return problem;
    if (borders_cross(query.holes[i], query.area))
      return bad(field, "the hole crosses the border of the area");
    if (!all_in(query.holes[i], query.area)) return bad(field, "the hole is outside the area");
    for (std::size_t j = 0; j < i; ++j)
      if (borders_cross(query.holes[i], query.holes[j]) || any_in(query.holes[i], query.holes[j]) ||
          any_in(query.holes[j], query.holes[i]))
        return bad(field, "the hole meets hole " + std::to_string(j));
  }
  double left = world::area(query.area);
  for (const Polygon& hole : query.holes) left -= world::area(hole);
  if (left > kNothing * world::area(query.area)) return std::nullopt;
  return bad("holes", "they leave nothing of the area to be swept");
}

std::optional<Refusal> check_speed(const CoverageQuery& query) {
  const world::VehicleModel& vehicle = query.vehicle;
  if (!std::isfinite(query.speed) || query.speed < 0)
    return bad("speed", figure(query.speed) + " m/s is not a speed");
  if (query.speed > vehicle.max_speed)
    return Refusal{RefusalKind::kBeyondVehicle, "speed",
                   figure(query.speed) + " m/s is more than the vehicle's " +
                       figure(vehicle.max_speed) + " m/s"};
  if (query.speed > 0 && query.speed < vehicle.min_speed)
    return Refusal{RefusalKind::kBeyondVehicle, "speed",
                   figure(query.speed) + " m/s is less than the vehicle's " +
                       figure(vehicle.min_speed) + " m/s"};
  return std::nullopt;
}

std::optional<Refusal> check_place(const std::optional<Vector3>& place, const std::string& field,
                                   const CoverageQuery& query, const world::World& world) {
  if (!place) return std::nullopt;
  if (auto problem = check_finite(*place, field)) return problem;
  const double ground = world.terrain.elevation(place->x(), place->y());
  if (place->z() < ground - 1)
    return Refusal{RefusalKind::kBlocked, field,
                   figure(ground - place->z()) + " m under the ground"};
  for (const world::Volume* volume : volumes_from(world, query.depart))
    if (enters(*place, *place, *volume))
      return Refusal{RefusalKind::kBlocked, field, "within the volume " + volume->name};
  return std::nullopt;
}

std::optional<Refusal> check_lanes(const CoverageQuery& query) {
  Vector2 low = query.area[0], high = query.area[0];
  for (const Vector2& corner : query.area) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const double lanes = (high - low).norm() / query.swath;
  if (lanes <= kMostLanes) return std::nullopt;
  return bad("swath", "a swath of " + figure(query.swath) + " m needs up to " + figure(lanes) +
                          " lanes; at most " + figure(kMostLanes) + " are planned");
}

}  // namespace

std::optional<Refusal> check_coverage(const CoverageQuery& query, const world::World& world) {
  if (auto problem = check_vehicle(query.vehicle)) return problem;
  if (auto problem = check_speed(query)) return problem;
  if (auto problem = check_positive(query.swath, "swath")) return problem;
  if (auto problem = check_positive(query.altitude, "altitude")) return problem;
  if (query.altitude > query.vehicle.ceiling)
    return Refusal{RefusalKind::kBeyondVehicle, "altitude",
                   figure(query.altitude) +
                       " m over the ground is above the vehicle's ceiling of " +
                       figure(query.vehicle.ceiling) + " m"};
  if (query.mode == SweepMode::kGiven && !std::isfinite(query.direction))
    return bad("direction", "the direction must be a finite number");
  if (auto problem = check_polygon(query.area, "area")) return problem;
  if (auto problem = check_in_world(query.area, world, "area")) return problem;
  if (query.turns_inside && !is_convex(query.area))
    return bad("turns_inside", "turns are kept inside of convex areas only");
  if (auto problem = check_holes(query)) return problem;
  if (auto problem = check_place(query.start, "start", query, world)) return problem;
  if (auto problem = check_place(query.end, "end", query, world)) return problem;
  return check_lanes(query);
}

std::vector<const world::Volume*> volumes_from(const world::World& world, MissionTime depart) {
  std::vector<const world::Volume*> found;
  for (const world::Volume& volume : world.volumes)
    if (volume.when.until > depart) found.push_back(&volume);
  return found;
}

bool enters(const Vector3& from, const Vector3& to, const world::Volume& volume) {
  double begin = 0, end = 1;
  const double rise = to.z() - from.z();
  if (std::abs(rise) < kTouch) {
    if (from.z() <= volume.floor || from.z() >= volume.ceiling) return false;
  } else {
    const double a = (volume.floor - from.z()) / rise, b = (volume.ceiling - from.z()) / rise;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
    if (begin >= end) return false;
  }
  const Vector3 first = from + begin * (to - from), last = from + end * (to - from);
  return runs_inside(first.head<2>(), last.head<2>(), volume.polygon);
}

}  // namespace skein::refiners
