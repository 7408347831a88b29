// SPDX-License-Identifier: Apache-2.0
#include "refinery/ways.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "flight/closed_air.hpp"
#include "flight/landing_place.hpp"
#include "skein/refiners/flyable.hpp"
#include "skein/refiners/voxel_path_planner.hpp"
#include "skein/world/crossing.hpp"
#include "skein/world/segment.hpp"

namespace skein::supervisor {

using refiners::Way;
using world::Vector3;

namespace {

constexpr double kTurnTolerance = 0.5;                        // [m]
constexpr double kAtHome = 1;                                 // [m] level
constexpr std::array<double, 2> kTurningRoom = {3, 5};        // turn radii to the side, for a turn
constexpr double kOutStep = 10, kFarthestOut = 600;           // [m] out of closed air,
constexpr std::array<double, 4> kOutAndUp = {0, 10, 20, 40};  // [m] from where it flies low
constexpr double kRoomOfOne = 46;      // [m] kept from where another waits, if there is room
constexpr double kRoomBelow = 15;      // [m] and over it
constexpr double kFarthestRoom = 160;  // [m] from where another waits: out of its room
constexpr double kTall = 8;            // [m] over and under it may be, too
constexpr double kGap = 0.5;           // [m] nearer that does not count
constexpr int kCorners = 8;            // of what stands for a circle,
constexpr double kInside = 0.92;       // its least radius
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

world::Volume disc(const Vector3& at, double radius, double height) {
  world::Volume room;
  room.name = "a partner's place";
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    room.polygon.emplace_back(at.head<2>() +
                              radius * world::Vector2(std::cos(angle), std::sin(angle)));
  }
  room.floor = at.z() - height;
  room.ceiling = at.z() + height;
  return room;
}

}  // namespace

Answer<Motion> Ways::takeoff(const Vector3& from, const Departure& when) const {
  if (vehicle().ground) return no("it keeps to the ground");
  const Vector3 to = gazetteer().above(from);
  Motion motion{{from, to}, {}, 0, {}};
  motion.times = takeoff_times(to.z() - gazetteer().ground(from), vehicle(), world().wind);
  const double around = air_.climb_radius(from, when);
  for (const world::Volume& volume : air_.closed(air_.counted(when, motion.times.most)))
    if (crosses(volume, around, from, to))
      return no("the air over it is closed (volume '" + volume.name + "')");
  motion.energy = motion.times.expected * world::flight_power(vehicle(), 0, vehicle().climb_rate) /
                  vehicle().energy.capacity;
  return motion;
}

Answer<Ways::Landing> Ways::landing_place(const Vector3& from, const Vector3& wanted,
                                          const Departure& when) const {
  if (vehicle().ground) return no("it keeps to the ground");
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
  if (vehicle().ground) return no("it keeps to the ground");
  const Vector3 down(to.x(), to.y(), gazetteer().ground(to));
  Motion motion{{from, down}, {}, 0, {}};
  motion.times = landing_times(std::max(0.0, from.z() - down.z()), vehicle());
  motion.energy = energy_of_stay(motion.times.expected);
  return motion;
}

Motion Ways::flown(Way way) const {
  if (vehicle().ground) return driven(std::move(way));
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
                                const std::vector<Spot>& others, const Departure& when) {
  const double guess = air_.has_windows() ? flown({from, to}).times.most : 0;
  return air_.kept_clear(from, when, guess, [&](const Counted& counted) -> Answer<Motion> {
    const auto air = air_.airspace(counted);
    if (!air) return no(air.error());
    return path_in(**air, air_.closed(counted), from, to, others);
  });
}

/// Where someone waits, as far as that leaves room around `to`; absent: it leaves none there.
std::optional<world::Volume> Ways::room_of(const Spot& other, const Vector3& to) const {
  double radius = std::max(kRoomOfOne, other.room);
  const double voxel = world().airspace.voxel;
  if (std::abs(to.z() - other.at.z()) < kRoomBelow + voxel)
    radius = std::min(radius, (to - other.at).head<2>().norm() - std::numbers::sqrt2 * voxel);
  if (radius <= 0) return std::nullopt;
  return disc(other.at, radius, kRoomBelow);
}

Ways::Crowd Ways::crowd_of(const std::vector<Spot>& others, const world::Airspace& air,
                           const Vector3& to) const {
  Crowd crowd{air, world(), {}};
  for (const Spot& other : others) {
    crowd.waiting.push_back(disc(other.at, other.room / kInside, kTall));
    const auto room = room_of(other, to);
    if (!room) continue;
    crowd.air.block(*room, 0);
    crowd.world.volumes.push_back(*room);
  }
  return crowd;
}

/// Where it is out of the rooms of others that it begins in: by a straight way that leads away from
/// all of them. `from` itself when it is in none.
std::optional<Vector3> Ways::out_of_rooms(const Crowd& crowd, const world::Airspace& air,
                                          const std::vector<Spot>& others, const Vector3& from) {
  if (crowd.air.is_free(from)) return from;
  const auto leads_away = [&](const Vector3& to) {
    return std::all_of(others.begin(), others.end(), [&](const Spot& other) {
      const double now = (from - other.at).norm();
      return now > kFarthestRoom || world::to_segment(other.at, from, to) >= now - kGap;
    });
  };
  const auto serves = [&](const Vector3& to) {
    return crowd.air.is_free(to) && air.is_free(from, to) && leads_away(to);
  };
  for (double far = kOutStep; far <= kFarthestRoom; far += kOutStep) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * std::numbers::pi * i / kDirections;
      const Vector3 to = from + far * Vector3(std::cos(angle), std::sin(angle), 0);
      if (serves(to)) return to;
    }
    for (const double up : {far, -far})
      if (const Vector3 to = from + Vector3(0, 0, up); serves(to)) return to;
  }
  return std::nullopt;
}

/// Around where the others wait, with what it flies beside its way and its circles at the end; if
/// turns have no room for that, around them at least as it is planned. Absent: there is no such
/// way.
std::optional<Way> Ways::clear_of(const std::vector<Spot>& others, const world::Airspace& air,
                                  const Volumes& volumes, const Vector3& from,
                                  const Vector3& to) const {
  Crowd crowd = crowd_of(others, air, to);
  const auto begin = out_of_rooms(crowd, air, others, from);
  if (!begin || !crowd.air.is_free(to)) return std::nullopt;
  const auto completed = [&](Answer<Way> on) -> std::optional<Way> {
    if (!on) return std::nullopt;
    if (*begin != from) on->insert(on->begin(), from);
    if (air_.met(*on, volumes)) return std::nullopt;
    return std::move(*on);
  };
  const auto disturbs = [&](const Way& way) {
    return !vehicle().hovers && air_.met(way, crowd.waiting);
  };
  const auto planned = completed(through(crowd.air, crowd.world, *begin, to));
  if (!planned || !disturbs(*planned)) return planned;
  Crowd roomy = crowd;
  for (const Spot& other : others)
    if (const auto room = room_of(other, to)) roomy.air.block(*room, vehicle().min_turn_radius);
  if (roomy.air.is_free(*begin) && roomy.air.is_free(to))
    if (const auto way = completed(through(roomy.air, roomy.world, *begin, to));
        way && !disturbs(*way))
      return way;
  for (const Vector3& over : beside(*begin)) {
    if (!crowd.air.is_free(*begin, over)) continue;
    auto on = through(crowd.air, crowd.world, over, to);
    if (on) on->insert(on->begin(), *begin);
    if (const auto way = completed(std::move(on)); way && !disturbs(*way)) return way;
  }
  return planned;
}

Answer<Motion> Ways::path_in(const world::Airspace& air, const Volumes& volumes,
                             const Vector3& from, const Vector3& to,
                             const std::vector<Spot>& others) {
  if (vehicle().ground) return drive(air, volumes, from, to);
  if (!air.is_free(from)) return out_and_on(from, to);
  if (from == to) return flown({from});
  const bool returns = (to - gazetteer().knowledge().home).head<2>().norm() < kAtHome;
  if (const auto* volume = air_.taking_room(to, volumes); volume != nullptr && !returns)
    return no("volume '" + volume->name + "' is " +
              (vehicle().hovers ? "nearer to its end than the vehicle strays"
                                : "too near for the circles that it waits on there"));
  if (!others.empty())
    if (auto way = clear_of(others, air, volumes, from, to)) return flown(std::move(*way));
  auto way = through(air, from, to);
  if (!way) return no(way.error());
  // Home it comes in any case: as far from closed air as its turns allow.
  const double whole = air_.stray();
  for (const double margin : returns ? std::vector{whole, whole / 2, 0.0} : std::vector{whole}) {
    if (!air_.met(*way, volumes, margin)) break;
    if (auto other = with_room(air, volumes, from, to, margin)) return flown(std::move(*other));
    if (!returns) return no("closed air is too near for its turns");
  }
  return flown(std::move(*way));
}

/// All around, from where there is room to turn.
std::vector<Vector3> Ways::beside(const Vector3& from) const {
  std::vector<Vector3> places;
  for (const double radii : kTurningRoom) {
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2 * std::numbers::pi * i / kAround;
      places.push_back(from + radii * vehicle().min_turn_radius *
                                  Vector3(std::cos(angle), std::sin(angle), 0));
    }
  }
  return places;
}

/// One whose turns and circles stay out of closed air: further away from that, or over a place
/// beside where it begins, from where there is room to turn.
std::optional<Way> Ways::with_room(const world::Airspace& air, const Volumes& volumes,
                                   const Vector3& from, const Vector3& to, double margin) const {
  world::Airspace roomy = air;
  for (const world::Volume& volume : volumes) roomy.block(volume, air_.stray() + air_.swing());
  if (auto way = through(roomy, from, to); way && !air_.met(*way, volumes, margin)) return *way;
  if (vehicle().hovers) return std::nullopt;
  for (const Vector3& over : beside(from)) {
    if (!air.is_free(from, over)) continue;
    auto on = through(air, over, to);
    if (!on) continue;
    on->insert(on->begin(), from);
    if (!air_.met(*on, volumes, margin)) return *on;
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
    for (const double up : kOutAndUp)
      for (int i = 0; i < kDirections; ++i) {
        const double angle = 2 * std::numbers::pi * i / kDirections;
        consider(from + Vector3(far * std::cos(angle), far * std::sin(angle), up),
                 std::max(far / vehicle().cruise_speed, up / vehicle().climb_rate));
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
