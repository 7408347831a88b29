// SPDX-License-Identifier: Apache-2.0
#include "refinery/ways.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "flight/closed_air.hpp"
#include "flight/crossing.hpp"
#include "flight/landing_place.hpp"
#include "skein/refiners/flyable.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::supervisor {

using refiners::Way;
using world::Vector3;

namespace {

constexpr double kTurnTolerance = 0.5;  // [m]
constexpr double kTurningRoom = 3;      // turn radii to the side, where a turn has no room
constexpr double kOutStep = 10, kFarthestOut = 600;   // [m] out of closed air
constexpr double kRoomOfOne = 46, kShareOfGap = 0.6;  // [m] where it waits, and of the distance
constexpr double kRoomBelow = 15;                     // [m] and over it
constexpr double kLeastRoomBelow = 10;                // [m] when one starts there
constexpr double kGap = 0.5;                          // [m] so that a face is not touched
constexpr int kDirections = 24, kAround = 8;

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

Answer<Motion> Ways::takeoff(const Vector3& from, const Departure& when) const {
  const Vector3 to = gazetteer().above(from);
  Motion motion{{from, to}, {}, 0, {}};
  motion.times = takeoff_times(to.z() - gazetteer().ground(from), vehicle(), world().wind);
  for (const world::Volume& volume : air_.closed(air_.counted(when, motion.times.most)))
    if (crosses(volume, vehicle().body_radius, from, to))
      return no("the air over it is closed (volume '" + volume.name + "')");
  motion.energy = motion.times.expected * world::flight_power(vehicle(), 0, vehicle().climb_rate) /
                  vehicle().energy.capacity;
  return motion;
}

Answer<Ways::Landing> Ways::landing_place(const Vector3& from, const Vector3& wanted,
                                          const Departure& when) const {
  const Knowledge& knowledge = gazetteer().knowledge();
  const Times flight = flown({from, gazetteer().flown_to(wanted)}).times;
  const Times descent = landing_times(knowledge.altitude, vehicle());
  const world::TimeWindow then =
      air_.window(when.after({flight.least, 0, flight.most}), descent.most);
  const auto problem = landing_problem(knowledge, world(), then, wanted);
  if (!problem) return Landing{wanted, {}};
  const auto at = supervisor::landing_place(knowledge, world(), then, from, wanted);
  if (!at) return no(*problem + ", and no ground near it serves");
  return Landing{*at, *problem};
}

Answer<Motion> Ways::landing(const Vector3& from, const Vector3& to) const {
  const Vector3 down(to.x(), to.y(), gazetteer().ground(to));
  Motion motion{{from, down}, {}, 0, {}};
  motion.times = landing_times(std::max(0.0, from.z() - down.z()), vehicle());
  motion.energy = energy_of_stay(motion.times.expected);
  return motion;
}

Motion Ways::flown(Way way) const {
  const refiners::Flight flight = refiners::estimate_flight(way, vehicle(), world().wind);
  Motion motion{std::move(way), {}, 0, {}};
  motion.times = flight_times(motion.way, vehicle(), world().wind);
  const double estimate = flight.duration.expected.to_seconds();
  motion.energy = flight.energy + energy_of_stay(std::max(0.0, motion.times.expected - estimate));
  return motion;
}

double Ways::energy_of_stay(double seconds) const {
  const double speed = vehicle().hovers ? 0 : vehicle().cruise_speed;
  return seconds * world::flight_power(vehicle(), speed, 0) / vehicle().energy.capacity;
}

Answer<Motion> Ways::path_among(const Vector3& from, const Vector3& to,
                                const std::vector<Vector3>& others, const Departure& when) {
  const double guess = air_.has_windows() ? flown({from, to}).times.most : 0;
  return air_.kept_clear(from, when, guess, [&](const Counted& counted) -> Answer<Motion> {
    const auto air = air_.airspace(counted);
    if (!air) return no(air.error());
    return path_in(**air, air_.closed(counted), from, to, others);
  });
}

/// Where someone waits, whatever it is that does, as far as that leaves room around `to` and in the
/// voxel of a start beside it. Absent: it leaves none there.
std::optional<world::Volume> Ways::room_of(const Vector3& other, const Vector3& to,
                                           const StartVoxel& start) {
  double radius = std::min(kRoomOfOne, kShareOfGap * (to - other).head<2>().norm());
  double floor = other.z() - kRoomBelow, ceiling = other.z() + kRoomBelow;
  const double beside = start.distance_to(other);
  const bool touches = beside <= radius && floor <= start.high.z() && start.low.z() <= ceiling;
  if (touches && start.high.z() + kGap <= other.z() - kLeastRoomBelow) {
    floor = start.high.z() + kGap;
  } else if (touches && start.low.z() - kGap >= other.z() + kLeastRoomBelow) {
    ceiling = start.low.z() - kGap;
  } else if (touches) {
    radius = beside - kGap;
  }
  if (radius <= 0) return std::nullopt;
  world::Volume room;
  room.name = "a partner's place";
  for (int i = 0; i < kAround; ++i) {
    const double angle = 2 * std::numbers::pi * i / kAround;
    room.polygon.emplace_back(other.head<2>() +
                              radius * world::Vector2(std::cos(angle), std::sin(angle)));
  }
  room.floor = floor;
  room.ceiling = ceiling;
  return room;
}

Ways::StartVoxel Ways::voxel_of(const world::Airspace& air, const Vector3& from) {
  const auto at = air.free_voxel_at(from);
  const Vector3 middle = at ? air.centre(*at) : from;
  const Vector3 half = Vector3::Constant(at ? air.grid().voxel / 2 : 0);
  return {middle - half, middle + half};
}

double Ways::StartVoxel::distance_to(const Vector3& other) const {
  const Vector3 nearest = other.cwiseMax(low).cwiseMin(high);
  return (other - nearest).head<2>().norm();
}

std::optional<Way> Ways::clear_of(const std::vector<Vector3>& others, world::Airspace air,
                                  const Volumes& volumes, const Vector3& from,
                                  const Vector3& to) const {
  world::World crowded = world();
  const StartVoxel start = voxel_of(air, from);
  for (const Vector3& other : others) {
    const auto room = room_of(other, to, start);
    if (!room) continue;
    air.block(*room, 0);
    crowded.volumes.push_back(*room);
  }
  if (!air.is_free(from) || !air.is_free(to)) return std::nullopt;
  auto way = through(air, crowded, from, to);
  return way && !air_.met(*way, volumes) ? std::optional(std::move(*way)) : std::nullopt;
}

Answer<Motion> Ways::path_in(const world::Airspace& air, const Volumes& volumes,
                             const Vector3& from, const Vector3& to,
                             const std::vector<Vector3>& others) {
  if (!air.is_free(from)) return out_and_on(from, to);
  if (from == to) return flown({from});
  const bool returns =
      (to - gazetteer().knowledge().home).head<2>().norm() < vehicle().orbit_radius;
  if (const auto* volume = air_.taking_room(to, volumes); volume != nullptr && !returns)
    return no("volume '" + volume->name + "' is " +
              (vehicle().hovers ? "nearer to its end than the vehicle strays"
                                : "too near for the circles that it waits on there"));
  if (!others.empty())
    if (auto way = clear_of(others, air, volumes, from, to)) return flown(std::move(*way));
  auto way = through(air, from, to);
  if (!way) return no(way.error());
  if (air_.met(*way, volumes)) {
    auto other = with_room(air, volumes, from, to);
    if (!other && !returns) return no("closed air is too near for its turns");
    if (other) way = std::move(*other);
  }
  return flown(std::move(*way));
}

/// One whose turns and circles stay out of closed air: further away from that, or over a place
/// beside where it begins, from where there is room to turn.
std::optional<Way> Ways::with_room(const world::Airspace& air, const Volumes& volumes,
                                   const Vector3& from, const Vector3& to) const {
  world::Airspace roomy = air;
  for (const world::Volume& volume : volumes) roomy.block(volume, air_.stray() + air_.swing());
  if (auto way = through(roomy, from, to); way && !air_.met(*way, volumes)) return *way;
  if (vehicle().hovers) return std::nullopt;
  const double radius = vehicle().min_turn_radius;
  for (int i = 0; i < kAround; ++i) {
    const double angle = 2 * std::numbers::pi * i / kAround;
    const Vector3 over =
        from + kTurningRoom * radius * Vector3(std::cos(angle), std::sin(angle), 0);
    if (!air.is_free(from, over)) continue;
    auto on = through(air, over, to);
    if (!on) continue;
    on->insert(on->begin(), from);
    if (!air_.met(*on, volumes)) return *on;
  }
  return std::nullopt;
}

Answer<Way> Ways::through(const world::Airspace& air, const Vector3& from,
                          const Vector3& to) const {
  return through(air, world(), from, to);
}

Answer<Way> Ways::through(const world::Airspace& air, const world::World& in, const Vector3& from,
                          const Vector3& to) const {
  const bool uniform = air.least_cost() == air.greatest_cost();
  if (uniform && air.is_free(from, to) &&
      refiners::is_flyable({from, to}, air_.cautious(), 0, kTurnTolerance))
    return Way{from, to};
  // One that cannot hover may need the other search's way to make room for its turns.
  const refiners::VoxelPathPlanner planner(
      air, vehicle().hovers ? refiners::WaySearch::kQuick : refiners::WaySearch::kThorough);
  auto refined = refine(air_.query(from, to), air_.setting(in, &planner));
  if (!refined) return no(refined.error().why);
  Way way = std::move(refined->task.way);
  if (!vehicle().hovers) way = thinned(way, air, vehicle().orbit_radius);
  return way;
}

Answer<Motion> Ways::way_out(const Vector3& from) {
  if (const auto air = air_.airspace(); !air) return no(air.error());
  std::optional<Vector3> out;
  double soonest = kFarthestOut / vehicle().cruise_speed;
  const auto consider = [&](const Vector3& to, double seconds) {
    if (seconds >= soonest || !world().terrain.line_of_sight(from, to) || !air_.may_stay(to))
      return;
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

Answer<Motion> Ways::out_and_on(const Vector3& from, const Vector3& to) {
  const auto out = way_out(from);
  if (!out) return out;
  auto on = path(out->way.back(), to);
  if (!on) return on;
  on->way.insert(on->way.begin(), from);
  return flown(std::move(on->way));
}

}  // namespace skein::supervisor
