// SPDX-License-Identifier: Apache-2.0
#include "refinery.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "autopilot.hpp"
#include "closed_air.hpp"
#include "crossing.hpp"
#include "landing_place.hpp"
#include "skein/refiners/flyable.hpp"
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
constexpr double kApart = 75;        // [m] between partners: circles of a blimp and what they waver
constexpr std::size_t kAroundOne = 6;  // places around one, that far from it and from each other
constexpr std::array<double, kAroundOne> kSlots = {1, -1, 2, -2, 3, 0};  // by rank
constexpr double kTurningRoom = 3;  // turn radii to the side, where a turn has no room
constexpr double kJoining = 1.3;    // of its circle: it is joined from inside and outside
constexpr double kOutStep = 10, kFarthestOut = 600;  // [m] out of closed air
constexpr int kDirections = 24, kAround = 8;
// Waiting circles' radii, straight before a lane that is taken up again.
constexpr double kRunIn = 2;

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

}  // namespace

Refinery::Refinery(Gazetteer gazetteer, MissionTime origin, std::uint64_t seed,
                   refiners::Budget budget)
    : gazetteer_(std::move(gazetteer)),
      cautious_(vehicle()),
      origin_(origin),
      seed_(seed),
      budget_(std::move(budget)) {
  const auto& volumes = world().volumes;
  has_windows_ = std::any_of(volumes.begin(), volumes.end(), [&](const world::Volume& volume) {
    return volume.when.from > origin || volume.when.until != MissionTime::max();
  });
  if (cautious_.hovers) return;
  cautious_.min_turn_radius = cautious_.orbit_radius;
  cautious_.climb_rate *= kClimbShare;
  cautious_.descent_rate *= kClimbShare;
}

refiners::Setting Refinery::setting(const refiners::PathPlanner* paths) const {
  return {world(), budget_, seed_, paths};
}

double Refinery::stray() const { return arrival_distance(vehicle(), world().wind); }

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
  Motion motion{std::move(way), {}, 0, {}};
  motion.times = flight_times(motion.way, vehicle(), world().wind);
  const double estimate = flight.duration.expected.to_seconds();
  motion.energy = flight.energy + energy_of_stay(std::max(0.0, motion.times.expected - estimate));
  return motion;
}

double Refinery::energy_of_stay(double seconds) const {
  const double speed = vehicle().hovers ? 0 : vehicle().cruise_speed;
  return seconds * world::flight_power(vehicle(), speed, 0) / vehicle().energy.capacity;
}

Answer<Motion> Refinery::takeoff(const Vector3& from, const Departure& when) const {
  const Vector3 to = gazetteer_.above(from);
  Motion motion{{from, to}, {}, 0, {}};
  motion.times = takeoff_times(to.z() - gazetteer_.ground(from), vehicle(), world().wind);
  for (const world::Volume& volume : closed(counted(when, motion.times.most)))
    if (crosses(volume, vehicle().body_radius, from, to))
      return no("the air over it is closed (volume '" + volume.name + "')");
  motion.energy = motion.times.expected * world::flight_power(vehicle(), 0, vehicle().climb_rate) /
                  vehicle().energy.capacity;
  return motion;
}

Answer<Refinery::Landing> Refinery::landing_place(const Vector3& from, const Vector3& wanted,
                                                  const Departure& when) const {
  const Knowledge& knowledge = gazetteer_.knowledge();
  const Times flight = flown({from, gazetteer_.flown_to(wanted)}).times;
  const Times descent = landing_times(knowledge.altitude, vehicle());
  const world::TimeWindow then = window(when.after({flight.least, 0, flight.most}), descent.most);
  const auto problem = landing_problem(knowledge, world(), then, wanted);
  if (!problem) return Landing{wanted, {}};
  const auto at = supervisor::landing_place(knowledge, world(), then, from, wanted);
  if (!at) return no(*problem + ", and no ground near it serves");
  return Landing{*at, *problem};
}

Answer<Motion> Refinery::landing(const Vector3& from, const Vector3& to) const {
  const Vector3 down(to.x(), to.y(), gazetteer_.ground(to));
  Motion motion{{from, down}, {}, 0, {}};
  motion.times = landing_times(std::max(0.0, from.z() - down.z()), vehicle());
  motion.energy = energy_of_stay(motion.times.expected);
  return motion;
}

Answer<const world::Airspace*> Refinery::airspace() { return airspace(counted({}, 0)); }

Answer<const world::Airspace*> Refinery::airspace(const Counted& counted) {
  const auto known = airspaces_.find(counted);
  if (known != airspaces_.end()) return &known->second;
  world::World then = world();
  std::size_t i = 0;
  std::erase_if(then.volumes, [&](const world::Volume&) { return !counted[i++]; });
  for (world::Volume& volume : then.volumes) volume.when = {};
  const Vector3 home = gazetteer_.above(gazetteer_.knowledge().home);
  auto made = refiners::airspace_of(query(home, home), {then, {}, seed_, nullptr});
  if (!made) return no(made.error().why);
  for (const world::Volume& volume : closed(counted)) made->block(volume, stray());
  return &airspaces_.emplace(counted, std::move(*made)).first->second;
}

Answer<Motion> Refinery::path(const Vector3& from, const Vector3& to, const Departure& when) {
  const double guess = has_windows_ ? flown({from, to}).times.most : 0;
  return kept_clear(from, when, guess, [&](const Counted& counted) -> Answer<Motion> {
    const auto air = airspace(counted);
    if (!air) return no(air.error());
    return path_in(**air, closed(counted), from, to);
  });
}

bool Refinery::has_room(const Vector3& at) const { return has_room(at, closed()); }

bool Refinery::has_room(const Vector3& at, const Volumes& volumes) const {
  return taking_room(at, volumes) == nullptr;
}

const world::Volume* Refinery::taking_room(const Vector3& at, const Volumes& volumes) const {
  const double around = vehicle().hovers ? stray() : kJoining * vehicle().orbit_radius + stray();
  const auto found = std::find_if(volumes.begin(), volumes.end(),
                                  [&](const auto& volume) { return is_near(volume, at, around); });
  return found == volumes.end() ? nullptr : &*found;
}

// One that hovers brakes for corners, and is carried beyond them all the same.
double Refinery::swing() const {
  if (!vehicle().hovers) return 2 * vehicle().min_turn_radius;
  return vehicle().cruise_speed * vehicle().cruise_speed / (2 * vehicle().acceleration);
}

/// As near as corners, and a wind across its longest leg, may carry one that hovers.
bool Refinery::comes_near(const Way& way, const Volumes& volumes) const {
  double longest = 0;
  for (std::size_t i = 1; i < way.size(); ++i)
    longest = std::max(longest, (way[i] - way[i - 1]).head<2>().norm());
  const double drift = vehicle().wind_drift * world().wind.speed / vehicle().cruise_speed;
  const double margin = stray() + swing() + drift * longest;
  return std::any_of(volumes.begin(), volumes.end(),
                     [&](const auto& volume) { return crosses(volume, margin, way); });
}

/// Some flight along the way, whichever way it comes to where that begins, or its circles at the
/// end are nearer to closed air than the vehicle strays; one that hovers, and whose ways keep that
/// distance, than half of that.
bool Refinery::met(const Way& way, const Volumes& volumes) const {
  if (volumes.empty() || way.size() < 2) return false;
  const bool hovers = vehicle().hovers;
  if (hovers && !comes_near(way, volumes)) return false;
  const double margin = hovers ? stray() / 2 : stray();
  const auto is_met = [&](const Vector3& at) {
    return std::any_of(volumes.begin(), volumes.end(),
                       [&](const auto& volume) { return is_near(volume, at, margin); });
  };
  const auto any_met = [&](const std::vector<Vector3>& track) {
    return std::any_of(track.begin(), track.end(), is_met);
  };
  const Way rest(way.begin() + 1, way.end());
  const double round = 2 * std::numbers::pi * vehicle().orbit_radius / vehicle().cruise_speed;
  for (const Pose& pose : poses_at(way.front(), vehicle())) {
    if (is_met(pose.at)) continue;
    const FlownWay flown = fly_way(pose, rest, vehicle(), world().wind);
    if (any_met(flown.track)) return true;
    if (hovers) continue;
    if (any_met(circle_over(flown.end, way.back(), vehicle(), world().wind, 2 * round)))
      return true;
  }
  return false;
}

Answer<Motion> Refinery::path_in(const world::Airspace& air, const Volumes& volumes,
                                 const Vector3& from, const Vector3& to) {
  if (!air.is_free(from)) return out_and_on(from, to);
  if (from == to) return flown({from});
  const bool returns = (to - gazetteer_.knowledge().home).head<2>().norm() < vehicle().orbit_radius;
  if (const auto* volume = taking_room(to, volumes); volume != nullptr && !returns)
    return no("volume '" + volume->name + "' is " +
              (vehicle().hovers ? "nearer to its end than the vehicle strays"
                                : "too near for the circles that it waits on there"));
  auto way = way_through(air, from, to);
  if (!way) return no(way.error());
  if (met(*way, volumes)) {
    auto other = way_with_room(air, volumes, from, to);
    if (!other && !returns) return no("closed air is too near for its turns");
    if (other) way = std::move(*other);
  }
  return flown(std::move(*way));
}

/// One whose turns and circles stay out of closed air: further away from that, or over a place
/// beside where it begins, from where there is room to turn.
std::optional<Way> Refinery::way_with_room(const world::Airspace& air, const Volumes& volumes,
                                           const Vector3& from, const Vector3& to) const {
  world::Airspace roomy = air;
  for (const world::Volume& volume : volumes) roomy.block(volume, stray() + swing());
  if (auto way = way_through(roomy, from, to); way && !met(*way, volumes)) return *way;
  if (vehicle().hovers) return std::nullopt;
  const double radius = vehicle().min_turn_radius;
  for (int i = 0; i < kAround; ++i) {
    const double angle = 2 * std::numbers::pi * i / kAround;
    const Vector3 over =
        from + kTurningRoom * radius * Vector3(std::cos(angle), std::sin(angle), 0);
    if (!air.is_free(from, over)) continue;
    auto on = way_through(air, over, to);
    if (!on) continue;
    on->insert(on->begin(), from);
    if (!met(*on, volumes)) return *on;
  }
  return std::nullopt;
}

Answer<Way> Refinery::way_through(const world::Airspace& air, const Vector3& from,
                                  const Vector3& to) const {
  const bool uniform = air.least_cost() == air.greatest_cost();
  if (uniform && air.is_free(from, to) &&
      refiners::is_flyable({from, to}, cautious(), 0, kTurnTolerance))
    return Way{from, to};
  // One that cannot hover may need the other search's way to make room for its turns.
  const refiners::VoxelPathPlanner planner(
      air, vehicle().hovers ? refiners::WaySearch::kQuick : refiners::WaySearch::kThorough);
  auto refined = refine(query(from, to), setting(&planner));
  if (!refined) return no(refined.error().why);
  Way way = std::move(refined->task.way);
  if (!vehicle().hovers) way = thinned(way, air, vehicle().orbit_radius);
  return way;
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

Answer<Motion> Refinery::rest(const Vector3& from, const Way& way, const world::SensorModel& device,
                              const world::SensorModel& before, const Departure& when) {
  return kept_clear(from, when, 0,
                    [&](const Counted& counted) { return rest_in(counted, way, device, before); });
}

Answer<Motion> Refinery::rest_in(const Counted& counted, const Way& way,
                                 const world::SensorModel& device,
                                 const world::SensorModel& before) {
  const auto air = airspace(counted);
  if (!air) return no(air.error());
  const double height = way.front().z() - gazetteer_.ground(way.front());
  const auto width = footprint(device, height), needed = footprint(before, height);
  if (!width) return no(width.error());
  if (needed && *width < *needed) return no(device.device + " sees less than " + before.device);
  for (std::size_t i = 1; i < way.size(); ++i)
    if (!(*air)->is_free(way[i - 1], way[i])) return no("air on what is left of it is closed");
  if (vehicle().hovers) return flown(way);
  // It comes to the first lane in its direction.
  const Vector3 along = (way[1] - way[0]).normalized();
  const Vector3 before_it = way[0] - kRunIn * vehicle().orbit_radius * along;
  Way with_run_in = {before_it};
  with_run_in.insert(with_run_in.end(), way.begin(), way.end());
  return flown((*air)->is_free(before_it, way[0]) ? std::move(with_run_in) : way);
}

Answer<std::vector<Vector3>> Refinery::views(const Vector3& place, const world::SensorModel& device,
                                             std::size_t count, const Departure& when,
                                             double seconds) {
  world::World then = world();
  const double there =
      flown({gazetteer_.above(gazetteer_.knowledge().home), gazetteer_.above(place)}).times.most;
  const Counted counts = counted(when, there + seconds);
  then.volumes = closed(counts);
  for (world::Volume& volume : then.volumes) volume.when = {};
  const auto air = airspace(counts);
  if (!air) return no(air.error());
  refiners::ViewpointQuery query;
  query.constraints.push_back({"free air", [this, free = *air, &then](const Vector3& at) {
                                 return free->is_free(at) &&
                                        (vehicle().hovers || has_room(at, then.volumes));
                               }});
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
  const refiners::Setting at_that_time{then, budget_, seed_, nullptr};
  auto refined = refine(query, at_that_time);
  if (!refined || refined->task.points.size() < count) {
    query.clearance = clearance() + vehicle().body_radius;
    auto lower = refine(query, at_that_time);
    const bool more =
        lower && (!refined || lower->task.points.size() > refined->task.points.size());
    if (more || !refined) refined = std::move(lower);
  }
  if (!refined) return no(refined.error().why);
  std::vector<Vector3> points;
  for (const refiners::ViewPoint& point : refined->task.points) points.push_back(point.position);
  return points;
}

Answer<std::vector<Vector3>> Refinery::places_around(const Vector3& at, std::size_t count) {
  const auto air = airspace();
  if (!air) return no(air.error());
  std::vector<Vector3> places = {at};
  // On the side that it comes from, lest it flies through the first: homes are near each other.
  const Vector3 back = gazetteer_.knowledge().home - at;
  const double step = 2 * std::numbers::pi / static_cast<double>(kAroundOne);
  for (std::size_t rank = 1; rank < count; ++rank) {
    const double distance = kApart * static_cast<double>(1 + (rank - 1) / kAroundOne);
    const double angle = std::atan2(back.y(), back.x()) + kSlots[(rank - 1) % kAroundOne] * step;
    // Turned by less than half of what is between two.
    std::optional<Vector3> found;
    for (const double turned : {0.0, 0.25, -0.25, 0.4, -0.4}) {
      const double to = angle + turned * step;
      const Vector3 beside = at + distance * Vector3(std::cos(to), std::sin(to), 0);
      if (!found && (*air)->is_free(beside) && has_room(beside)) found = beside;
    }
    if (!found) return no("no free air beside it for " + std::to_string(count) + " partners");
    places.push_back(*found);
  }
  return places;
}

Answer<std::vector<Vector3>> Refinery::tour(const Vector3& from,
                                            const std::vector<Vector3>& places) {
  const auto air = airspace(counted({.suited = true}, 0));
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
