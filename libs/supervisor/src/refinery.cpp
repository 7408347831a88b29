// SPDX-License-Identifier: Apache-2.0
#include "refinery.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "crossing.hpp"
#include "landing_place.hpp"
#include "skein/refiners/flyable.hpp"
#include "skein/refiners/patrol.hpp"
#include "skein/refiners/tour.hpp"
#include "skein/refiners/viewpoint.hpp"

namespace skein::supervisor {

using refiners::Way;
using world::Vector3;

namespace {

constexpr double kLeastClearance = 5;                 // [m]
constexpr double kAngleApart = std::numbers::pi / 3;  // [rad] between two views
constexpr double kTurnTolerance = 0.5;                // [m]
constexpr double kCostOfWay = 1e-4;                   // of utility, per metre
constexpr double kNearShare = 0.5;                    // of its range, for a sensor to see well
constexpr double kSteep = 1.25;      // distances over heights that it must reach at least
constexpr double kClimbShare = 0.8;  // of its rates, in ways of a vehicle that cannot hover
constexpr double kOutStep = 10, kFarthestOut = 600;  // [m] out of closed air
constexpr int kDirections = 24, kAround = 8;
constexpr double kEnough = 1e-6;  // [s]

tl::unexpected<std::string> no(std::string why) {
  return tl::unexpected<std::string>(std::move(why));
}

/// Without the points of arcs that are nearer to the last one kept than `spacing`, where the air
/// between is free: a vehicle that cannot hover turns back for each way-point that it misses.
Way thinned(const Way& way, const world::Airspace& air, double spacing) {
  Way kept = {way.front()};
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    const bool near = (way[i] - kept.back()).head<2>().norm() < spacing;
    if (!near || !air.is_free(kept.back(), way[i + 1])) kept.push_back(way[i]);
  }
  if (way.size() > 1) kept.push_back(way.back());
  return kept;
}

double heading_to(const Vector3& from, const world::Polygon& polygon) {
  world::Vector2 middle = world::Vector2::Zero();
  for (const world::Vector2& corner : polygon) middle += corner;
  middle /= static_cast<double>(polygon.size());
  return std::atan2(middle.y() - from.y(), middle.x() - from.x());
}

}  // namespace

Refinery::Refinery(Gazetteer gazetteer, MissionTime origin, std::uint64_t seed)
    : gazetteer_(std::move(gazetteer)), cautious_(vehicle()), origin_(origin), seed_(seed) {
  if (cautious_.hovers) return;
  cautious_.min_turn_radius = cautious_.orbit_radius;
  cautious_.climb_rate *= kClimbShare;
  cautious_.descent_rate *= kClimbShare;
}

refiners::Setting Refinery::setting(const refiners::PathPlanner* paths) const {
  return {world(), {}, seed_, paths};
}

double Refinery::clearance() const {
  return std::max(kLeastClearance, 4 * world::tracking_spread(vehicle()));
}

refiners::PathQuery Refinery::query(const Vector3& from, const Vector3& to) const {
  refiners::PathQuery query;
  query.vehicle = cautious();
  query.from = from;
  query.to = to;
  query.clearance = clearance();
  query.depart = origin_;
  return query;
}

Motion Refinery::flown(Way way) const {
  const refiners::Flight flight = refiners::estimate_flight(way, vehicle(), world().wind);
  Motion motion{std::move(way), {}, 0};
  motion.times = flight_times(motion.way, vehicle(), world().wind);
  const double estimate = flight.duration.expected.to_seconds();
  motion.energy = flight.energy + energy_of_stay(std::max(0.0, motion.times.expected - estimate));
  return motion;
}

double Refinery::energy_of_stay(double seconds) const {
  const double speed = vehicle().hovers ? 0 : vehicle().cruise_speed;
  return seconds * world::flight_power(vehicle(), speed, 0) / vehicle().energy.capacity;
}

Answer<Motion> Refinery::takeoff(const Vector3& from) const {
  const Vector3 to = gazetteer_.above(from);
  for (const world::Volume& volume : world().volumes)
    if (origin_ < volume.when.until && crosses(volume, vehicle().body_radius, from, to))
      return no("the air over it is closed (volume '" + volume.name + "')");
  Motion motion{{from, to}, {}, 0};
  motion.times = takeoff_times(to.z() - gazetteer_.ground(from), vehicle(), world().wind);
  motion.energy = motion.times.expected * world::flight_power(vehicle(), 0, vehicle().climb_rate) /
                  vehicle().energy.capacity;
  return motion;
}

Answer<Refinery::Landing> Refinery::landing_place(const Vector3& from,
                                                  const Vector3& wanted) const {
  const Knowledge& knowledge = gazetteer_.knowledge();
  const auto problem = landing_problem(knowledge, world(), origin_, wanted);
  if (!problem) return Landing{wanted, {}};
  const auto at = supervisor::landing_place(knowledge, world(), origin_, from, wanted);
  if (!at) return no(*problem + ", and no ground near it serves");
  return Landing{*at, *problem};
}

Answer<Motion> Refinery::landing(const Vector3& from, const Vector3& to) const {
  const Vector3 down(to.x(), to.y(), gazetteer_.ground(to));
  Motion motion{{from, down}, {}, 0};
  motion.times = landing_times(std::max(0.0, from.z() - down.z()), vehicle());
  motion.energy = energy_of_stay(motion.times.expected);
  return motion;
}

Answer<const world::Airspace*> Refinery::airspace() {
  if (!airspace_) {
    const Vector3 home = gazetteer_.above(gazetteer_.knowledge().home);
    auto made = refiners::airspace_of(query(home, home), setting());
    if (!made) return no(made.error().why);
    airspace_.emplace(std::move(*made));
  }
  return &*airspace_;
}

Answer<Motion> Refinery::path(const Vector3& from, const Vector3& to) {
  const auto air = airspace();
  if (!air) return no(air.error());
  if (!(*air)->is_free(from)) return out_and_on(from, to);
  const bool uniform = (*air)->least_cost() == (*air)->greatest_cost();
  if (from == to) return flown({from});
  if (uniform && (*air)->is_free(from, to) &&
      refiners::is_flyable({from, to}, cautious(), 0, kTurnTolerance))
    return flown({from, to});
  const refiners::VoxelPathPlanner planner(**air);
  auto refined = refine(query(from, to), setting(&planner));
  if (!refined) return no(refined.error().why);
  Way way = std::move(refined->task.way);
  if (!vehicle().hovers) way = thinned(way, **air, vehicle().orbit_radius);
  return flown(std::move(way));
}

bool Refinery::may_stay(const Vector3& at) {
  const auto air = airspace();
  if (!air || !(*air)->is_free(at)) return false;
  const double radius = stay_radius(vehicle());
  for (int i = 0; i < kAround; ++i) {
    const double angle = 2 * std::numbers::pi * i / kAround;
    if (!(*air)->is_free(at + radius * Vector3(std::cos(angle), std::sin(angle), 0))) return false;
  }
  return true;
}

Answer<Motion> Refinery::way_out(const Vector3& from) {
  if (const auto air = airspace(); !air) return no(air.error());
  std::optional<Vector3> out;
  double soonest = kFarthestOut / vehicle().cruise_speed;
  const auto consider = [&](const Vector3& to, double seconds) {
    if (seconds >= soonest || !world().terrain.line_of_sight(from, to) || !may_stay(to)) return;
    soonest = seconds;
    out = to;
  };
  for (double far = kOutStep; far <= kFarthestOut; far += kOutStep) {
    consider(from + Vector3(0, 0, far), far / vehicle().climb_rate);
    consider(from - Vector3(0, 0, far), far / vehicle().descent_rate);
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * std::numbers::pi * i / kDirections;
      consider(from + far * Vector3(std::cos(angle), std::sin(angle), 0),
               far / vehicle().cruise_speed);
    }
  }
  if (!out) return no("it begins in closed air, and no free air is near");
  return flown({from, *out});
}

Answer<Motion> Refinery::out_and_on(const Vector3& from, const Vector3& to) {
  const auto out = way_out(from);
  if (!out) return out;
  auto on = path(out->way.back(), to);
  if (!on) return on;
  on->way.insert(on->way.begin(), from);
  return flown(std::move(on->way));
}

Answer<double> Refinery::footprint(const world::SensorModel& device, double height) const {
  if (height <= 0 || height >= device.range)
    return no(device.device + " reaches " + std::to_string(std::lround(device.range)) +
              " m, and would look from " + std::to_string(std::lround(height)) +
              " m over the ground");
  const double reach = std::sqrt(device.range * device.range - height * height);
  return std::min(reach, height * std::tan(device.aperture));
}

Answer<Motion> Refinery::patrol(const Vector3& from, const world::Zone& zone,
                                const world::SensorModel& device, double seconds) const {
  refiners::PatrolQuery query;
  query.vehicle = cautious();
  query.zone = zone.polygon;
  query.start = from;
  query.heading = heading_to(from, zone.polygon);
  query.altitude = from.z() - gazetteer_.ground(from);
  const auto width = footprint(device, query.altitude);
  if (!width) return no(width.error());
  query.footprint = *width;
  query.duration = Duration::seconds(seconds);
  query.depart = origin_;
  auto refined = refine(query, setting());
  if (!refined) return no(refined.error().why);
  Way way = std::move(refined->task.way);
  // The refiner counts neither turns nor braking: what would come too late is not flown.
  const std::vector<double> passages = expected_passages(way, vehicle(), world().wind);
  std::size_t kept = way.size();
  while (kept > 2 && passages[kept - 1] > seconds + kEnough) --kept;
  if (kept < way.size() && vehicle().hovers) {
    const double leg = passages[kept] - passages[kept - 1];
    const double part = std::clamp((seconds - passages[kept - 1]) / leg, 0.0, 1.0);
    way[kept] = way[kept - 1] + part * (way[kept] - way[kept - 1]);
    ++kept;
  }
  way.resize(kept);
  return flown(std::move(way));
}

Answer<Motion> Refinery::sweep(const Vector3& from, const world::Zone& zone,
                               const world::SensorModel& device) const {
  refiners::CoverageQuery query;
  query.vehicle = cautious();
  query.area = zone.polygon;
  query.altitude = std::min(gazetteer_.knowledge().altitude, vehicle().ceiling);
  const auto width = footprint(device, query.altitude);
  if (!width) return no(width.error());
  // What the vehicle wavers must not leave gaps between lanes.
  query.swath = 2 * std::max(*width / 2, *width - world::tracking_spread(vehicle()));
  query.start = gazetteer_.flown_to(from);
  query.depart = origin_;
  auto refined = refine(query, setting());
  if (!refined) return no(refined.error().why);
  const Way& way = refined->task.way;
  const world::Vector2 first = refined->task.lanes.front().from;
  const auto entry = std::min_element(way.begin(), way.end(), [&](const auto& a, const auto& b) {
    return (a.template head<2>() - first).norm() < (b.template head<2>() - first).norm();
  });
  return flown(Way(entry, way.end()));
}

Answer<std::vector<Vector3>> Refinery::views(const Vector3& place, const world::SensorModel& device,
                                             std::size_t count) {
  const auto air = airspace();
  if (!air) return no(air.error());
  refiners::ViewpointQuery query;
  query.constraints.push_back(
      {"free air", [free = *air](const Vector3& at) { return free->is_free(at); }});
  query.vehicle = cautious();
  query.device = device.device;
  query.target = place;
  // On the side of home, and near enough to see well; the same places whoever asks and from where,
  // so that partners take different ones and who is there stays.
  query.from = gazetteer_.above(gazetteer_.knowledge().home);
  query.cost_of_way = kCostOfWay;
  // From the usual altitude; lower only where the sensor does not reach from there.
  query.clearance = std::min(gazetteer_.knowledge().altitude, vehicle().ceiling / 2);
  query.farthest =
      std::min(device.range, std::max(device.range * kNearShare, kSteep * query.clearance));
  query.count = count;
  query.least_angle = count > 1 ? kAngleApart : 0;
  query.at = origin_;
  auto refined = refine(query, setting());
  if (!refined || refined->task.points.size() < count) {
    query.clearance = clearance() + vehicle().body_radius;
    auto lower = refine(query, setting());
    const bool more =
        lower && (!refined || lower->task.points.size() > refined->task.points.size());
    if (more || !refined) refined = std::move(lower);
  }
  if (!refined) return no(refined.error().why);
  std::vector<Vector3> points;
  for (const refiners::ViewPoint& point : refined->task.points) points.push_back(point.position);
  return points;
}

Answer<std::vector<Vector3>> Refinery::tour(const Vector3& from,
                                            const std::vector<Vector3>& places) {
  const auto air = airspace();
  if (!air) return no(air.error());
  refiners::TourQuery query;
  query.vehicle = cautious();
  query.start = gazetteer_.flown_to(from);
  for (const Vector3& place : places) {
    const Vector3 at = gazetteer_.flown_to(place);
    query.stops.push_back({std::to_string(query.stops.size() + 1), {{at, at, Duration()}}});
  }
  query.clearance = clearance();
  query.depart = origin_;
  const refiners::VoxelPathPlanner planner(**air);
  const auto refined = refine(query, setting(&planner));
  if (!refined) return no(refined.error().why);
  std::vector<Vector3> order;
  for (const refiners::Visit& visit : refined->task.visits)
    order.push_back(query.stops[visit.stop].gates.front().entry);
  return order;
}

}  // namespace skein::supervisor
