// SPDX-License-Identifier: Apache-2.0
#include "refinery/timed_air.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "flight/closed_air.hpp"
#include "flight/flights_met.hpp"
#include "refinery/zone_shapes.hpp"
#include "skein/refiners/voxel_path_planner.hpp"
#include "skein/world/crossing.hpp"
#include "skein/world/segment.hpp"
#include "skein/world/steering.hpp"

namespace skein::supervisor {

using refiners::Way;
using world::Vector3;

namespace {

constexpr double kLeastClearance = 5;  // [m]
constexpr double kClimbShare = 0.8;    // of its rates, in ways of a vehicle that cannot hover
constexpr std::array<double, 3> kRaised = {10, 20, 40};  // [m] more over ground that turns meet
constexpr int kAround = 8;
constexpr double kSamePlace = 0.5;      // [m]
constexpr int kCoarse = 4, kFine = 16;  // directions from which a flight begins
constexpr double kTurnInWind = 3;       // radii across a turn
constexpr std::uint64_t kShaken =
    4;  // flights in thought with errors and gusts, beside the calm one

}  // namespace

TimedAir::TimedAir(Gazetteer gazetteer, MissionTime origin, std::uint64_t seed,
                   refiners::Budget budget)
    : gazetteer_(std::move(gazetteer)),
      cautious_(vehicle()),
      origin_(origin),
      seed_(seed),
      budget_(std::move(budget)),
      start_(vehicle()) {
  const auto& volumes = world().volumes;
  has_windows_ = std::any_of(volumes.begin(), volumes.end(), [&](const world::Volume& volume) {
    return volume.when.from > origin || volume.when.until != MissionTime::max();
  });
  if (cautious_.hovers) return;
  cautious_.min_turn_radius = cautious_.orbit_radius;
  cautious_.climb_rate *= kClimbShare;
  cautious_.descent_rate *= kClimbShare;
}

bool TimedAir::still_stands(const Departure& when) const {
  if (!start_.stand()) return false;
  const double height = gazetteer().knowledge().altitude;
  return when.least < takeoff_times(height, vehicle(), world().wind).least +
                          landing_times(height, vehicle()).least;
}

// It circles around where it stands.
double TimedAir::climb_radius(const Vector3& from, const Departure& when) const {
  if (vehicle().hovers) return vehicle().body_radius;
  const bool there = still_stands(when) && (from - *start_.stand()).head<2>().norm() < kSamePlace;
  return vehicle().body_radius + vehicle().orbit_radius + (there ? 0 : stay_radius(vehicle()));
}

double TimedAir::longest(const Way& way) const {
  return flight_times(way, vehicle(), world().wind).most;
}

refiners::Setting TimedAir::setting(const refiners::PathPlanner* paths) const {
  return {world(), budget_, seed_, paths};
}

refiners::Setting TimedAir::setting(const world::World& world,
                                    const refiners::PathPlanner* paths) const {
  return {world, budget_, seed_, paths};
}

double TimedAir::stray() const { return arrival_distance(vehicle(), world().wind); }

double TimedAir::reach() const { return waiting_reach(vehicle(), world().wind); }

double TimedAir::clearance() const {
  return std::max(kLeastClearance, 4 * world::tracking_spread(vehicle())) + raised_;
}

refiners::PathQuery TimedAir::query(const Vector3& from, const Vector3& to) const {
  refiners::PathQuery query;
  query.vehicle = cautious();
  query.from = from;
  query.to = to;
  query.clearance = clearance();
  query.depart = origin_;
  return query;
}

TimedAir::Counted TimedAir::counted(const Departure& when, double seconds) const {
  const world::TimeWindow flight = window(when, seconds);
  Counted all;
  for (const world::Volume& volume : world().volumes) {
    const bool touches = volume.when.overlaps(flight) || volume.when.from == flight.from;
    const bool lasts = volume.when.from <= flight.from && flight.until <= volume.when.until;
    all.push_back(when.suited ? lasts : touches);
  }
  return all;
}

world::TimeWindow TimedAir::window(const Departure& when, double seconds) const {
  const auto at = [&](double s) {
    return std::isinf(s) ? MissionTime::max() : origin_ + Duration::seconds(s);
  };
  return {at(when.least), at(when.most + seconds)};
}

TimedAir::Volumes TimedAir::closed() const { return closed(counted({}, 0)); }

TimedAir::Volumes TimedAir::closed(const Counted& counted) const {
  Volumes all;
  for (std::size_t i = 0; i < counted.size(); ++i)
    if (counted[i] && world().volumes[i].polygon.size() > 2) all.push_back(world().volumes[i]);
  return all;
}

Answer<const world::Airspace*> TimedAir::airspace() { return airspace(counted({}, 0)); }

Answer<const world::Airspace*> TimedAir::airspace(const Counted& counted) {
  const auto known = airspaces_.find({raised_, counted});
  if (known != airspaces_.end()) return &known->second;
  if (vehicle().ground) {
    auto map = refiners::drivable_ground(world().terrain, vehicle(), closed(counted), stray());
    return &airspaces_.emplace(std::pair(raised_, counted), std::move(map)).first->second;
  }
  world::World then = world();
  std::size_t i = 0;
  std::erase_if(then.volumes, [&](const world::Volume&) { return !counted[i++]; });
  for (world::Volume& volume : then.volumes) volume.when = {};
  const Vector3 home = gazetteer_.above(gazetteer_.knowledge().home);
  auto made = refiners::airspace_of(query(home, home), {then, {}, seed_, nullptr});
  if (!made) return no(made.error().why);
  for (const world::Volume& volume : closed(counted)) made->block(volume, stray());
  return &airspaces_.emplace(std::pair(raised_, counted), std::move(*made)).first->second;
}

bool TimedAir::has_room(const Vector3& at, const Volumes& volumes) const {
  return taking_room(at, volumes) == nullptr;
}

const world::Volume* TimedAir::taking_room(const Vector3& at, const Volumes& volumes) const {
  const double around = reach();
  const auto found = std::find_if(volumes.begin(), volumes.end(),
                                  [&](const auto& volume) { return is_near(volume, at, around); });
  return found == volumes.end() ? nullptr : &*found;
}

// One that hovers brakes for corners, and is carried beyond them all the same.
double TimedAir::swing() const {
  if (!vehicle().hovers) return 2 * vehicle().min_turn_radius;
  return world::braking_distance(vehicle(), vehicle().cruise_speed);
}

/// As near as corners, and a wind across its longest leg, may carry one that hovers.
bool TimedAir::comes_near(const Way& way, const Volumes& volumes) const {
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
/// distance, than half of that, be it shaken on its flight: what errors and gusts make of its
/// corners is more than what they are themselves.
bool TimedAir::met(const Way& way, const Volumes& volumes, std::optional<double> margin) const {
  if (volumes.empty() || way.size() < 2) return false;
  const bool hovers = vehicle().hovers;
  if (hovers && !comes_near(way, volumes)) return false;
  const double least = margin.value_or(stray());
  // Where its first turn may come to one it does so from few places of its circle.
  const double turn = vehicle().orbit_radius + kTurnInWind * vehicle().min_turn_radius + least;
  const bool is_beside = std::ranges::any_of(
      volumes, [&](const world::Volume& one) { return is_near(one, way.front(), turn); });
  return flights_meet(way, volumes, vehicle(), world().wind, {hovers ? least / 2 : least, kShaken},
                      start_.poses(way.front(), in_flight_now_, is_beside ? kFine : kCoarse));
}

bool TimedAir::meets_ground(const Way& way) const {
  if (vehicle().hovers || vehicle().ground) return false;
  const double least = vehicle().body_radius + 2 * world::tracking_spread(vehicle());
  return flights_meet_ground(way, world().terrain, {least, kShaken, stray() + swing()}, vehicle(),
                             world().wind, start_.poses(way.front(), in_flight_now_));
}

bool TimedAir::may_stay(const Vector3& at) {
  const auto air = airspace();
  if (!air || !(*air)->is_free(in_airspace(at))) return false;
  const double radius = stay_radius(vehicle());
  for (int i = 0; i < kAround; ++i) {
    const double angle = 2 * std::numbers::pi * i / kAround;
    const Vector3 beside = at + radius * Vector3(std::cos(angle), std::sin(angle), 0);
    if (!(*air)->is_free(in_airspace(beside))) return false;
  }
  // A corner comes between two of these.
  const Volumes volumes = closed(counted({}, 0));
  return std::none_of(volumes.begin(), volumes.end(), [&](const auto& volume) {
    return is_near(volume, at, vehicle().body_radius + radius);
  });
}

bool TimedAir::may_stay(const Vector3& at, const Departure& when, double seconds) const {
  return has_landed(at) || has_room(at, closed(counted(when, seconds)));
}

bool TimedAir::stays_open(const Vector3& at, const Departure& when, double seconds) const {
  if (!has_windows_ || has_landed(at)) return true;
  Counted closing = counted(when, seconds);
  const Counted before = counted({when.least, when.least}, 0);
  for (std::size_t i = 0; i < closing.size(); ++i) closing[i] = closing[i] && !before[i];
  return has_room(at, closed(closing));
}

bool TimedAir::stays_open(const Way& way, const Departure& when) const {
  return !has_windows_ || !met(way, closed(counted(when, longest(way))));
}

// Higher over steep ground, where its turns come too near to that. Home it comes in any case.
Answer<Motion> TimedAir::kept_clear(const Vector3& from, const Departure& when, double seconds,
                                    const Planner& plan) {
  const auto higher = [&]() -> Answer<Motion> {
    for (const double raised : kRaised) {
      raised_ = raised;
      auto motion = clear_of_all(from, when, seconds, plan);
      raised_ = 0;
      if (motion && !meets_ground(motion->way)) return motion;
    }
    return no("the ground is too near for its turns");
  };
  const bool before = std::exchange(in_flight_now_, start_.in_flight(when));
  auto motion = clear_of_all(from, when, seconds, plan);
  if (motion && meets_ground(motion->way)) {
    const Vector3 off = motion->way.back() - gazetteer_.knowledge().home;
    const bool returns = off.head<2>().norm() < vehicle().orbit_radius;
    if (auto clear = higher(); clear || !returns) motion = std::move(clear);
  }
  in_flight_now_ = before;
  return motion;
}

Answer<Motion> TimedAir::clear_of_all(const Vector3& from, const Departure& when, double seconds,
                                      const Planner& plan) const {
  Counted counts = counted(when, seconds);
  while (true) {
    auto motion = plan(counts);
    if (!motion || !has_windows_) return motion;
    const Vector3& first = motion->way.front();
    const double approach = first == from ? 0 : longest({from, first});
    Counted all = counted(when, approach + motion->times.most);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = all[i] || counts[i];
    if (all == counts) return motion;
    counts = std::move(all);
  }
}

world::World TimedAir::over(const world::Zone& zone, const Vector3& from, double footprint,
                            double margin, const Counted& air) const {
  world::World local = world();
  local.ground = ground_over(zone.polygon, world().ground, footprint);
  local.volumes = closed(air);
  const bool inside =
      std::any_of(local.volumes.begin(), local.volumes.end(), [&](const auto& volume) {
        return world::to_polygon(from.head<2>(), grown(volume, stray()).polygon) <= 0;
      });
  if (!inside)
    for (world::Volume& volume : local.volumes) volume = grown(volume, margin);
  return local;
}

}  // namespace skein::supervisor
