// SPDX-License-Identifier: Apache-2.0
#include "refinery/patrols.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "flight/autopilot.hpp"
#include "flight/closed_air.hpp"
#include "refinery/zone_shapes.hpp"
#include "skein/refiners/patrol.hpp"
#include "skein/world/segment.hpp"
#include "skein/world/steering.hpp"

namespace skein::supervisor {

using refiners::Way;
using world::Polygon;
using world::Vector2;
using world::Vector3;

namespace {

constexpr double kMoves = 0.02;     // [m] in a step of a track: it heads there,
constexpr double kTurnsNose = 1;    // [m/s] and one that hovers at such a speed
constexpr double kSteepLook = 0.1;  // [rad] from straight down
constexpr double kInSight = 0.8;    // of its footprint, from the zone at most
// Of its time a patrol of one that cannot hover has the zone in sight, at least: what a detection
// promises (docs/comets-domain.md). What it sees from beyond kInSight is for errors and gusts.
constexpr double kTurningShare = 0.85;
constexpr double kOutOfSight = 1.25;   // times as long as it would take with the zone in sight
constexpr double kLongestPatrol = 6;   // times as long as it would take with the zone in sight
constexpr double kLeastPatrol = 60;    // [s] planned, of which so much is flown as it takes
constexpr int kLongerPatrols = 6;      // tried, until the zone is in sight for long enough
constexpr double kLongest = 4;         // times as long as the one before, at most
constexpr std::uint64_t kFlights = 6;  // in thought, with errors and gusts
constexpr double kTightest = 1.15;     // turn radii of circles over a small zone
constexpr double kSpacing = 2;         // turn radii between points of arcs: none is circled then
constexpr int kSides = 8;              // of a circle
constexpr int kWays = 4;               // to and fro
constexpr std::size_t kMostPoints = 4000;
// Of the search for walks [64 changes tried], about half a second: a patrol of a mission lasts a
// few rounds, and is planned again and again.
constexpr std::uint64_t kSearched = 30'000;

/// Without the points nearer to the last one kept than `spacing`.
Way spaced(const Way& way, double spacing) {
  Way kept;
  for (const Vector3& point : way)
    if (kept.empty() || (point - kept.back()).head<2>().norm() >= spacing) kept.push_back(point);
  return kept;
}

/// Of flights with errors and gusts.
FlownWay quickest_flight(const Pose& from, const Way& way, const world::VehicleModel& vehicle,
                         const world::Wind& wind) {
  FlownWay quickest = fly_way(from, way, vehicle, wind, 1);
  for (std::uint64_t trial = 2; trial <= kFlights; ++trial) {
    FlownWay flown = fly_way(from, way, vehicle, wind, trial);
    if (flown.seconds < quickest.seconds) quickest = std::move(flown);
  }
  return quickest;
}

}  // namespace

/// Where the nose of a vehicle points that begins with a heading and flies along a track: one that
/// hovers turns it no faster than it can, and not at all while it hardly moves.
class Nose {
 public:
  Nose(const world::VehicleModel& vehicle, double heading)
      : most_(vehicle.yaw_rate * kTrackStep),
        moves_(vehicle.hovers ? kTurnsNose * kTrackStep : kMoves),
        turns_at_once_(!vehicle.hovers),
        heading_(heading) {}
  void follow(const Vector2& step) {
    if (step.norm() <= moves_) return;
    const double turn = world::wrapped(std::atan2(step.y(), step.x()) - heading_);
    heading_ += turns_at_once_ ? turn : std::clamp(turn, -most_, most_);
  }
  Vector2 direction() const { return {std::cos(heading_), std::sin(heading_)}; }

 private:
  double most_, moves_;
  bool turns_at_once_;
  double heading_;
};

/// How long the zone was in sight during a flight.
class Patrols::Sight {
 public:
  Sight(const FlownWay& flown, Nose nose, const Polygon& zone, const Look& look) {
    for (std::size_t i = 0; i < flown.track.size(); ++i) {
      const Vector2 at = flown.track[i].head<2>();
      if (i > 0) nose.follow(at - flown.track[i - 1].head<2>());
      const double off = look.aim ? (*look.aim - at).norm()
                                  : world::to_polygon(at + look.ahead * nose.direction(), zone);
      const bool in_sight = off <= kInSight * look.reach;
      if (in_sight && !is_seen_) first_ = static_cast<double>(out_.size()) * kTrackStep;
      is_seen_ = is_seen_ || in_sight;
      out_.push_back((out_.empty() ? 0 : out_.back()) + (in_sight ? 0 : kTrackStep));
    }
  }
  /// Since it was first, after so many seconds.
  double since_first(double seconds) const { return is_seen_ ? seconds - first_ : 0; }
  /// Of the first so many seconds.
  double until(double seconds) const {
    const auto sample = static_cast<std::size_t>(seconds / kTrackStep);
    return std::max(0.0, seconds - out_[std::min(sample, out_.size() - 1)]);
  }

 private:
  std::vector<double> out_;  ///< until each sample, out of sight [s]
  double first_ = 0;         ///< [s]
  bool is_seen_ = false;
};

/// A device that looks down sees what is below; one that is tilted sees the ground ahead: around
/// its axis, or where that meets the ground out of its range, as far as its range lets it.
Patrols::Look Patrols::look_of(const world::SensorModel& device, double height, double footprint) {
  const double down = std::max(kSteepLook, -device.boresight_pitch);
  if (down > std::numbers::pi / 2 - kSteepLook) return {0, footprint, {}, footprint};
  const double nearest = height / std::tan(std::min(std::numbers::pi / 2, down + device.aperture));
  const double furthest = std::sqrt(device.range * device.range - height * height);
  const double ahead = std::min(height / std::tan(down), (nearest + furthest) / 2);
  const double around = std::max(footprint, std::hypot(height, ahead) * std::tan(device.aperture));
  return {ahead, std::min(around, furthest - ahead), {}, footprint};
}

Answer<Way> Patrols::planned(const world::World& world, const Vector3& from,
                             const world::Zone& zone, double footprint, double seconds) const {
  refiners::PatrolQuery query;
  query.vehicle = air_.cautious();
  query.zone = zone.polygon;
  query.start = from;
  query.heading = heading_to(from, zone.polygon);
  query.altitude = from.z() - gazetteer().ground(from);
  query.footprint = footprint;
  query.duration = Duration::seconds(seconds);
  query.depart = air_.origin();
  refiners::Setting setting = air_.setting(world);
  setting.budget.steps = std::min(setting.budget.steps, kSearched);
  auto refined = refine(query, setting);
  if (!refined) return no(refined.error().why);
  if (vehicle().hovers) return std::move(refined->task.way);
  return spaced(refined->task.way, kSpacing * vehicle().min_turn_radius);
}

/// A flight along a way, and how far along it the zone was in sight for how long.
class Patrols::Filling {
 public:
  Filling(const Way& way, FlownWay flown, Sight sight, bool hovers)
      : way_(&way), flown_(std::move(flown)), sight_(std::move(sight)), hovers_(hovers) {}

  double seconds() const { return flown_.seconds; }
  double most() const { return std::max(done(flown_.seconds), 1e-3); }
  /// Seconds until that many points of the way are passed.
  double until_passed(std::size_t points) const { return flown_.passages[points - 2]; }
  /// The part of the way after which it was in sight for so long.
  std::optional<Way> cut(double seconds) const {
    for (std::size_t i = 1; i < way_->size(); ++i) {
      const double more = done(flown_.passages[i - 1]) - seconds;
      if (more < 0) continue;
      Way part(way_->begin(), way_->begin() + static_cast<std::ptrdiff_t>(i) + 1);
      const double leg = flown_.passages[i - 1] - (i > 1 ? flown_.passages[i - 2] : 0);
      // Of one that hovers the last leg may end anywhere.
      if (hovers_ && more < leg) part.back() += more / leg * ((*way_)[i - 1] - (*way_)[i]);
      return part;
    }
    return std::nullopt;
  }

 private:
  double done(double at) const {
    // Turns beyond the zone are part of a patrol of one that cannot hover, within reason.
    const double share = hovers_ ? 1 : kTurningShare;
    return std::min(sight_.since_first(at), sight_.until(at) / share);
  }

  const Way* way_;
  FlownWay flown_;
  Sight sight_;
  bool hovers_;
};

/// The part of a way after which the zone was in sight for so long, as the autopilot flies it and
/// as quick as that may be; nothing, and how many times as long it would have to be.
std::optional<Way> Patrols::filled(const Way& way, const world::Zone& zone, const Look& look,
                                   double seconds, double& longer) const {
  if (way.size() < 2) return std::nullopt;
  Pose start = poses_at(way.front(), vehicle()).front();
  start.heading = heading_to(way.front(), zone.polygon);
  const Way rest(way.begin() + 1, way.end());
  const auto as_flown = [&](FlownWay flown) {
    Sight sight(flown, Nose(vehicle(), start.heading), zone.polygon, look);
    return Filling(way, std::move(flown), std::move(sight), vehicle().hovers);
  };
  Filling filling = as_flown(fly_way(start, rest, vehicle(), world().wind));
  longer = seconds / filling.most();
  if (longer > 1) return std::nullopt;  // without asking how quick it may be, which takes long
  const Times whole = flight_times(way, vehicle(), world().wind);
  // Without errors it can miss points near each other again and again that it passes else.
  if (vehicle().hovers && filling.seconds() > whole.expected)
    filling = as_flown(quickest_flight(start, rest, vehicle(), world().wind));
  // What it takes from where it begins is known of one that hovers.
  const auto needed_along = [&](const Way& part, const Times& times) {
    const double taken = vehicle().hovers ? filling.until_passed(part.size()) : times.expected;
    return seconds + std::max(0.0, std::min(taken, times.expected) - times.least);
  };
  const double needed = needed_along(way, whole);
  longer = needed / filling.most();
  const std::optional<Way> part = filling.cut(needed);
  // A part that is much shorter can be quicker by less.
  return part && part->size() < way.size()
             ? filling.cut(needed_along(*part, flight_times(*part, vehicle(), world().wind)))
             : part;
}

std::vector<Way> Patrols::rounds(const Vector3& from, const world::Zone& zone, double footprint,
                                 const Counted& air) const {
  const double radius =
      vehicle().hovers ? 2 * world::reaching_distance(vehicle(), world().wind)
                       : std::clamp(kInSight * footprint, kTightest * vehicle().min_turn_radius,
                                    vehicle().orbit_radius);
  const Vector2 middle = middle_of(zone.polygon);
  const double height = from.z() - gazetteer().ground(from);
  const double towards = std::atan2(from.y() - middle.y(), from.x() - middle.x());
  const TimedAir::Volumes volumes = air_.closed(air);
  const auto is_open = [&](const Vector3& at) {
    return world().terrain.contains(at.x(), at.y()) &&
           at.z() - gazetteer().ground(at) <= vehicle().ceiling &&
           std::none_of(volumes.begin(), volumes.end(),
                        [&](const auto& volume) { return is_near(volume, at, air_.stray()); });
  };
  // One that cannot hover flies them level: it climbs less than steep ground does.
  const auto levelled = [&](Way way) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Vector3& at : way) highest = std::max(highest, at.z());
    for (Vector3& at : way) at.z() = highest;
    return way;
  };
  const auto round = [&](int corners, double turned) {
    Way way;
    for (int i = 0; i < corners; ++i) {
      const double angle = towards + turned + 2 * std::numbers::pi * i / corners;
      const Vector2 at = middle + radius * Vector2(std::cos(angle), std::sin(angle));
      way.emplace_back(at.x(), at.y(), world().terrain.elevation(at.x(), at.y()) + height);
    }
    return vehicle().hovers ? way : levelled(std::move(way));
  };
  std::vector<Way> rounds = {round(kSides, 0)};
  for (int i = 0; vehicle().hovers && i < kWays; ++i)
    rounds.push_back(round(2, std::numbers::pi * i / kWays));
  std::erase_if(rounds,
                [&](const Way& way) { return !std::all_of(way.begin(), way.end(), is_open); });
  return rounds;
}

/// Nothing where there is no way to it.
std::optional<Way> Patrols::again_and_again(const Vector3& from, const Way& round, double seconds,
                                            const Counted& counted) {
  Way way = {from};
  if (!air_.closed(counted).empty() || air_.meets_ground({from, round.front()})) {
    const auto air = air_.airspace(counted);
    if (!air) return std::nullopt;
    if ((*air)->is_free(from)) {
      auto there = ways_.through(**air, from, round.front());
      if (!there) return std::nullopt;
      there->pop_back();
      way = std::move(*there);
    }
  }
  double about = 0;
  for (std::size_t i = 0; i < round.size(); ++i)
    about += (round[i] - round[(i + 1) % round.size()]).norm();
  const double length = seconds * vehicle().cruise_speed;
  for (double flown = 0; flown < length && way.size() < kMostPoints; flown += about)
    way.insert(way.end(), round.begin(), round.end());
  return way;
}

Answer<Motion> Patrols::over(const Vector3& from, const world::Zone& zone,
                             const world::SensorModel& device, double seconds,
                             const Departure& when) {
  if (air_.vehicle().ground) return no("it keeps to the ground, and patrols no zone");
  auto motion = air_.kept_clear(from, when, seconds, [&](const Counted& air) {
    return over_in(air, from, zone, device, seconds);
  });
  if (motion && !when.suited && !air_.stays_open(from, when, motion->times.most))
    return no("the air where it begins closes meanwhile");
  return motion;
}

Answer<Motion> Patrols::over_in(const Counted& air, const Vector3& from, const world::Zone& zone,
                                const world::SensorModel& device, double seconds) {
  const double height = from.z() - gazetteer().ground(from);
  const auto width = footprint(device, height);
  if (!width) return no(width.error());
  const Look look = look_of(device, height, *width);
  Answer<Motion> motion = no(device.device + " has no ground ahead within its range from " +
                             std::to_string(std::lround(height)) + " m over it");
  if (look.reach > 0) motion = flown_over(air, from, zone, look, seconds);
  const double approach = world::to_polygon(from.head<2>(), zone.polygon) / vehicle().cruise_speed;
  const bool serves = motion && motion->times.expected <= kOutOfSight * (seconds + approach);
  if (serves || look.ahead <= 0 || !device.gimballed) return motion;
  // Ahead of it there is little but what lies beyond a small zone: its middle can be aimed at.
  const Vector2 middle = middle_of(zone.polygon);
  const double reach = std::sqrt(device.range * device.range - height * height);
  auto aimed = flown_over(air, from, zone, {0, reach, middle, *width}, seconds);
  if (!aimed || (motion && motion->times.expected <= aimed->times.expected)) return motion;
  const Vector3 at(middle.x(), middle.y(), 0);
  aimed->aim = Vector3(middle.x(), middle.y(), gazetteer().ground(at));
  return aimed;
}

/// Lanes; with more room where closed air has too little for its turns. Over a zone that is smaller
/// than what it strays, and where lanes have no room: rounds.
Answer<Motion> Patrols::flown_over(const Counted& air, const Vector3& from, const world::Zone& zone,
                                   const Look& look, double seconds) {
  auto lanes = in_lanes(air, from, zone, look, seconds, air_.stray());
  if (!lanes && !air_.closed(air).empty()) {
    auto roomy = in_lanes(air, from, zone, look, seconds, air_.stray() + air_.swing());
    if (roomy) return roomy;
  }
  if (lanes) return lanes;
  auto motion = in_rounds(air, from, zone, look, seconds);
  return motion ? std::move(motion) : std::move(lanes);
}

Answer<Motion> Patrols::in_lanes(const Counted& air, const Vector3& from, const world::Zone& zone,
                                 const Look& look, double seconds, double margin) const {
  const world::World local = air_.over(zone, from, look.width, margin, air);
  const TimedAir::Volumes volumes = air_.closed(air);
  const double approach = world::to_polygon(from.head<2>(), zone.polygon) / vehicle().cruise_speed;
  const double in_sight = std::max(seconds + approach, kLeastPatrol);
  double duration = in_sight, longer = 1;
  for (int i = 0; i < kLongerPatrols && duration <= kLongestPatrol * in_sight; ++i) {
    const auto way = planned(local, from, zone, look.width, duration);
    if (!way) return no(way.error());
    if (auto part = filled(*way, zone, look, seconds, longer)) {
      if (air_.met(*part, volumes)) return no("closed air is too near for its turns");
      return ways_.flown(std::move(*part));
    }
    duration *= std::clamp(1.05 * longer, 1.1, kLongest);
  }
  return no("its time cannot be filled");
}

Answer<Motion> Patrols::in_rounds(const Counted& air, const Vector3& from, const world::Zone& zone,
                                  const Look& look, double seconds) {
  const double approach = world::to_polygon(from.head<2>(), zone.polygon) / vehicle().cruise_speed;
  for (const Way& round : rounds(from, zone, look.width, air)) {
    double duration = std::max(seconds + approach, kLeastPatrol), longer = 1;
    for (int i = 0; i < kLongerPatrols; ++i, duration *= std::clamp(1.05 * longer, 1.1, kLongest)) {
      const auto way = again_and_again(from, round, duration, air);
      if (!way) break;
      auto part = filled(*way, zone, look, seconds, longer);
      if (!part) continue;
      if (air_.met(*part, air_.closed(air))) break;
      return ways_.flown(std::move(*part));
    }
  }
  return no("there is no room for rounds over it");
}

}  // namespace skein::supervisor
