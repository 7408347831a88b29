// SPDX-License-Identifier: Apache-2.0
#include "merging/airways.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "path_query.hpp"
#include "skein/decision_node/way_search.hpp"
#include "skein/elementary/parameter_reader.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/refiners/path.hpp"
#include "skein/world/crossing.hpp"
#include "skein/world/segment.hpp"

namespace skein::decision_node {

namespace {

using merging::Margins;
using merging::Way;
using world::Vector2;
using world::Vector3;

constexpr double kStep = 12;            // [m] between heights
constexpr int kSteps = 5;               // heights above the one that was asked for
constexpr double kUnderground = -1000;  // [m] below all ground: landings end anywhere above
constexpr int kStepsDown = 2;
constexpr double kOverGround = 5;  // [m] stay the margins of whoever gets out of the way downwards
constexpr int kDirections = 8;
constexpr std::array kRings{2, 4, 6, 8, 12, 18, 26, 36, 48};  // of what it takes to hold
constexpr double kNearEnd = 1.05;  // an end is in what is reserved with what it has too much
constexpr double kSame = 0.01;     // [m] nearer is as near
constexpr double kAhead = 600;     // [s] in which air must not close on a way that nobody asked for

elementary::Situation seen_by_vehicle(const MergingConfig& config,
                                      const AirwaySituation& situation) {
  return {config.model, *config.terrain, situation.state, true};
}

/// Flown from where it holds or circles, if it is there.
Vector3 start_of(const AirwaySituation& situation, const Margins& margins) {
  const Vector3& at = situation.state.position;
  const bool rests = situation.rest && (*situation.rest - at).norm() <= margins.settled;
  return rests || (situation.rest && !margins.hovers) ? *situation.rest : at;
}

functional::Request along(functional::Request request, const Way& way) {
  const std::vector<Vector3>& points = way.way_points();
  functional::Parameters parameters{
      elementary::points_parameter("waypoints", {points.begin() + 1, points.end()})};
  for (const functional::Parameter& one : request.parameters.all())
    if (one.name != "waypoints") parameters.add(one);
  request.parameters = std::move(parameters);
  return request;
}

Airway flight(const functional::Request& request, const std::vector<Vector3>& points,
              const Margins& margins, double raised, bool from_rest = true) {
  const Way way(points, margins, from_rest);
  return {along(request, way), way, way.volumes(), way.points().back(), raised};
}

/// Straight up, over, and straight down again.
std::vector<Vector3> raised_by(const std::vector<Vector3>& points, double height) {
  const Vector3 up(0, 0, height);
  std::vector<Vector3> result{points.front()};
  for (const Vector3& point : points) result.push_back(point + up);
  result.push_back(points.back());
  return result;
}

/// From where it got out of the way upwards it comes down where it begins what it was sent for.
std::vector<Vector3> from_aside(const std::vector<Vector3>& points) {
  if (points[0].z() < points[1].z() + kStep / 2) return points;
  std::vector<Vector3> result = points;
  result.insert(result.begin() + 1, {points[1].x(), points[1].y(), points[0].z()});
  return result;
}

/// Likewise, down at once: of one that cannot hover the way to a pattern was planned from down
/// there, so that it comes into its first lane along it.
std::vector<Vector3> down_at_once(const std::vector<Vector3>& points) {
  if (points[0].z() < points[1].z() + kStep / 2) return points;
  std::vector<Vector3> result = points;
  result.insert(result.begin() + 1, {points[0].x(), points[0].y(), points[1].z()});
  return result;
}

/// Who is nearer than the margin to closed air may fly away from there, and comes no nearer.
double kept_from(const world::Volume& volume, double margin, const Vector3& start) {
  const double above = std::max({volume.floor - start.z(), start.z() - volume.ceiling, 0.0});
  const double beside = world::to_polygon(start.head<2>(), volume.polygon);
  return std::clamp(std::max(above, beside) - kSame, 0.0, margin);
}

/// It begins in the volume, leads out of it, and not back.
bool leaves(const world::Volume& volume, const std::vector<Vector3>& points) {
  const auto out = std::find_if_not(points.begin(), points.end(), [&](const Vector3& point) {
    return world::crosses(volume, 0, point, point);
  });
  if (out == points.begin() || out == points.end()) return false;
  return !world::crosses(volume, 0, std::vector<Vector3>(out, points.end()));
}

bool is_clear(const std::vector<Vector3>& points, double margin, const AirwaySituation& situation) {
  const world::TimeWindow ahead{situation.now, situation.now + Duration::seconds(kAhead)};
  return std::none_of(situation.volumes.begin(), situation.volumes.end(), [&](const auto& volume) {
    return volume.when.overlaps(ahead) && !leaves(volume, points) &&
           world::crosses(volume, kept_from(volume, margin, points.front()), points);
  });
}

bool can_fly(const Airway& airway, const MergingConfig& config, const AirwaySituation& situation) {
  return elementary::checked_task(airway.request.type, airway.request.parameters,
                                  seen_by_vehicle(config, situation))
      .has_value();
}

Airways flights(const functional::Request& request, const elementary::GotoTask& task,
                bool at_any_height, const MergingConfig& config, const AirwaySituation& situation) {
  const Margins margins = merging::margins_of(config.model, config.wind, task.speed);
  std::vector<Vector3> points{start_of(situation, margins)};
  points.insert(points.end(), task.waypoints.begin(), task.waypoints.end());
  const std::vector<Vector3> level = situation.aside ? from_aside(points) : points;
  Airways all;
  if (level != points && !margins.hovers && is_clear(down_at_once(points), margins.way, situation))
    all.push_back(flight(request, down_at_once(points), margins, 0));
  if (level != points && is_clear(level, margins.way, situation))
    all.push_back(flight(request, level, margins, 0));
  all.push_back(flight(request, points, margins, 0, !situation.passing));
  if (!at_any_height) return all;
  for (int step = 1; step <= kSteps; ++step) {
    Airway higher = flight(request, raised_by(level, step * kStep), margins, step * kStep);
    if (is_clear(higher.way->points(), margins.way, situation) &&
        can_fly(higher, config, situation))
      all.push_back(std::move(higher));
  }
  return all;
}

/// What others have, as wide and high as keeps a way out of it; where it begins and ends, only as
/// much as where it stays.
void reserve(refiners::PathQuery& query, const merging::Volumes& taken, const Margins& margins) {
  const auto nears_end = [&](const merging::Volume& volume) {
    for (const Vector3& end : {query.from, query.to}) {
      const Vector2 at = end.head<2>();
      const double off = world::between_segments(volume.from, volume.to, at, at);
      const bool beside = off < kNearEnd * (volume.radius + margins.way);
      if (beside && end.z() < volume.ceiling + kNearEnd * margins.slope &&
          end.z() > volume.floor - kNearEnd * margins.slope)
        return true;
    }
    return false;
  };
  for (const merging::Volume& volume : taken) {
    const bool near = nears_end(volume);
    query.reserved.push_back(closed_around(volume, near ? margins.hold : margins.way,
                                           near ? margins.level : margins.slope));
  }
}

Airway column_of(const functional::Request& request, double low, double high,
                 std::optional<Vector3> end, const MergingConfig& config,
                 const AirwaySituation& situation) {
  const Margins margins = merging::margins_of(config.model, config.wind, config.model.cruise_speed);
  const Vector3 at = end ? *end : start_of(situation, margins);
  return {request, std::nullopt, {column(at.head<2>(), low, high, margins)}, end, 0};
}

/// Whether what is kept free below a place to stay is free of the ground there and around it.
bool is_over_ground(const Vector3& place, const Margins& margins, const world::Terrain& terrain) {
  const double least = place.z() - margins.level - kOverGround;
  if (terrain.elevation(place.x(), place.y()) > least) return false;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDirections;
    const double x = place.x() + margins.hold * std::cos(angle);
    const double y = place.y() + margins.hold * std::sin(angle);
    if (terrain.elevation(x, y) > least) return false;
  }
  return true;
}

/// Up, then to places around, at each of these heights above, and at last down.
std::vector<std::vector<Vector3>> lines_aside(const Vector3& from, double hold,
                                              const std::vector<double>& heights) {
  std::vector<std::vector<Vector3>> lines;
  for (int step = 1; step <= kSteps; ++step)
    lines.push_back({from, from + Vector3(0, 0, step * kStep)});
  for (const double height : heights) {
    const Vector3 above = from + Vector3(0, 0, height);
    for (const int ring : kRings) {
      for (int i = 0; i < kDirections; ++i) {
        const double angle = 2 * std::numbers::pi * i / kDirections;
        const Vector3 place = above + ring * hold * Vector3(std::cos(angle), std::sin(angle), 0);
        lines.push_back(height > 0 ? std::vector<Vector3>{from, above, place}
                                   : std::vector<Vector3>{from, place});
      }
    }
  }
  for (int step = 1; step <= kStepsDown; ++step)
    lines.push_back({from, from - Vector3(0, 0, step * kStep)});
  return lines;
}

}  // namespace

AirwaySituation resting_at(AirwaySituation situation, const Vector3& place) {
  situation.state.position = place;
  situation.rest = place;
  return situation;
}

bool needs_air(const functional::Request& request) {
  return functional::TaskTypes::shipped().of(request.type).motion == functional::Motion::kMoves;
}

std::optional<elementary::GotoTask> flight_of(const functional::Request& request,
                                              const MergingConfig& config,
                                              const AirwaySituation& situation) {
  const auto task = elementary::checked_task(request.type, request.parameters,
                                             seen_by_vehicle(config, situation));
  const auto* flown = task ? std::get_if<elementary::GotoTask>(&*task) : nullptr;
  return flown != nullptr ? std::optional(*flown) : std::nullopt;
}

bool is_done_in_place(const functional::Request& request) {
  const functional::TaskType& type = functional::TaskTypes::shipped().of(request.type);
  const bool looks = type.motion == functional::Motion::kKeeps && !type.devices.empty();
  return looks || request.type == "land";
}

Result<Airways, Failure> airways_of(const functional::Request& request, bool at_any_height,
                                    const MergingConfig& config, const AirwaySituation& situation) {
  const auto task = elementary::checked_task(request.type, request.parameters,
                                             seen_by_vehicle(config, situation));
  if (!task) return tl::unexpected(task.error());
  const Vector3& at = situation.state.position;
  return std::visit(
      Overloaded{[&](const elementary::TakeoffTask& it) -> Airways {
                   const Vector3 top(at.x(), at.y(), it.height);
                   return {column_of(request, at.z(), it.height, top, config, situation)};
                 },
                 [&](const elementary::LandTask&) -> Airways {
                   return {column_of(request, kUnderground, at.z(), {}, config, situation)};
                 },
                 [&](const elementary::GotoTask& it) -> Airways {
                   if (it.waypoints.empty()) return {{request, {}, {}, {}, 0}};
                   return flights(request, it, at_any_height, config, situation);
                 },
                 [&](const auto&) -> Airways {
                   return {{request, {}, {}, {}, 0}};
                 }},
      *task);
}

merging::Volumes air_from(const Vector3& place, const functional::Request& request,
                          const MergingConfig& config, const AirwaySituation& situation) {
  if (!needs_air(request)) return {};
  const auto airways = airways_of(request, false, config, resting_at(situation, place));
  return airways && !airways->empty() ? airways->front().air : merging::Volumes();
}

Airways flights_to(const Vector3& place, functional::TaskId id, const MergingConfig& config,
                   const AirwaySituation& situation) {
  functional::Request request{functional::Verb::kDispatch, id, "goto", {}};
  request.parameters.add(elementary::points_parameter("waypoints", {place}));
  return airways_of(request, true, config, situation).value_or(Airways());
}

merging::Volume landing_at(const Vector3& place, const Margins& margins) {
  return column(place.head<2>(), kUnderground, place.z(), margins);
}

std::optional<refiners::PathQuery> query_around(const functional::Request& request,
                                                const merging::Volumes& taken,
                                                const MergingConfig& config,
                                                const AirwaySituation& situation) {
  const auto flown = flight_of(request, config, situation);
  if (!flown || flown->waypoints.empty()) return std::nullopt;
  const Margins margins = merging::margins_of(config.model, config.wind, flown->speed);
  const Vector3 from = start_of(situation, margins);
  refiners::PathQuery query =
      path_query(config.model, from, flown->waypoints.back(), situation.now);
  query.speed = flown->speed;
  reserve(query, taken, margins);
  return query;
}

std::optional<Airway> airway_along(const functional::Request& request, const refiners::Path& path,
                                   const merging::Volumes& taken, const MergingConfig& config,
                                   const AirwaySituation& situation) {
  const auto flown = flight_of(request, config, situation);
  if (!flown || path.way.size() < 2) return std::nullopt;
  const Margins margins = merging::margins_of(config.model, config.wind, flown->speed);
  if ((path.way.front() - start_of(situation, margins)).norm() > margins.settled)
    return std::nullopt;
  Airway way = flight(request, path.way, margins, 0);
  way.energy = path.energy;
  const bool clear = !overlap(way.air, taken) &&
                     is_clear(way.way->points(), margins.way, situation) &&
                     can_fly(way, config, situation);
  return clear ? std::optional(way) : std::nullopt;
}

functional::Request begun_at(const Vector3& place, const functional::Request& request,
                             const MergingConfig& config, const AirwaySituation& situation) {
  const auto flown = flight_of(request, config, situation);
  if (!flown || flown->waypoints.empty()) return request;
  const Margins margins = merging::margins_of(config.model, config.wind, flown->speed);
  const Vector3 from = start_of(situation, margins);
  if ((place - from).norm() <= margins.settled) return request;
  std::vector<Vector3> points{from, place};
  points.insert(points.end(), flown->waypoints.begin(), flown->waypoints.end());
  return along(request, Way(points, margins));
}

functional::Request led_around(const functional::Request& request, const MergingConfig& config,
                               const AirwaySituation& situation,
                               const std::shared_ptr<const world::World>& world) {
  const auto flown = flight_of(request, config, situation);
  if (!flown || flown->waypoints.empty()) return request;
  const Margins margins = merging::margins_of(config.model, config.wind, flown->speed);
  const Vector3 from = start_of(situation, margins);
  const Vector3& first = flown->waypoints.front();
  if (is_clear({from, first}, config.model.body_radius, situation)) return request;
  const auto path = search_way({path_query(config.model, from, first, situation.now), world});
  if (!path || path->way.size() < 2) return request;
  std::vector<Vector3> points = path->way;
  points.insert(points.end(), flown->waypoints.begin() + 1, flown->waypoints.end());
  return along(request, Way(points, margins));
}

Airways ways_aside(functional::TaskId id, const merging::Volumes& others,
                   const MergingConfig& config, const AirwaySituation& situation,
                   const std::vector<double>& heights) {
  const Margins margins = merging::margins_of(config.model, config.wind, config.model.cruise_speed);
  const Vector3 from = start_of(situation, margins);
  Airways all;
  for (const std::vector<Vector3>& points : lines_aside(from, margins.hold, heights)) {
    const Vector3& end = points.back();
    const bool is_low = end.z() < from.z() && !is_over_ground(end, margins, *config.terrain);
    if (is_low || overlap({stay_at(end, margins)}, others)) continue;
    Airway one = flight({functional::Verb::kDispatch, id, "goto", {}}, points, margins, 0);
    if (is_clear(one.way->points(), margins.way, situation) && can_fly(one, config, situation))
      all.push_back(std::move(one));
  }
  return all;
}

}  // namespace skein::decision_node
