// SPDX-License-Identifier: Apache-2.0
// Patrols and sweeps, judged by how the autopilot will fly them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "autopilot.hpp"
#include "closed_air.hpp"
#include "refinery.hpp"
#include "skein/refiners/patrol.hpp"

namespace skein::supervisor {

using refiners::Way;
using world::Polygon;
using world::Vector2;
using world::Vector3;

namespace {

constexpr double kMoves = 0.02;        // [m] in a step of a track: it heads there
constexpr double kSteepLook = 0.1;     // [rad] from straight down
constexpr double kInSight = 0.8;       // of its footprint, from the zone at most
constexpr double kTurningShare = 0.8;  // of its time a patrol has the zone in sight, at least
constexpr double kOutOfSight = 1.25;   // times as long as it would take with the zone in sight
constexpr double kLongestPatrol = 6;   // times as long as it would take with the zone in sight
constexpr int kLongerPatrols = 6;      // tried, until the zone is in sight for long enough
constexpr std::size_t kMostCells = 100'000;
constexpr double kCellsAcross = 6;  // of a zone, at least
constexpr double kLongest = 4;      // times as long as the one before, at most
constexpr double kTightest = 1.15;  // turn radii of circles over a small zone
constexpr double kSpacing = 2;      // turn radii between points of arcs: none is circled then
constexpr int kFinerGrounds = 8;    // tried, until some cell has its middle in a sliver
constexpr int kSides = 8;           // of a circle
constexpr int kWays = 4;            // to and fro
constexpr std::size_t kMostPoints = 4000;
constexpr double kSamples = 24;       // across a zone, to see what is seen of it
constexpr double kRunIn = 3;          // turn radii before the first lane
constexpr double kLaneSpacing = 2.5;  // turn radii between way-points along lanes
constexpr double kSeenEnough = 0.998;
constexpr double kSureShare = 1.4;  // deviations by which it may see less far

tl::unexpected<std::string> no(std::string why) {
  return tl::unexpected<std::string>(std::move(why));
}

struct Box {
  Vector2 low, high;
  double least_side() const { return (high - low).minCoeff(); }
};

Box box_of(const Polygon& polygon) {
  Box box{polygon.front(), polygon.front()};
  for (const Vector2& corner : polygon) {
    box.low = box.low.cwiseMin(corner);
    box.high = box.high.cwiseMax(corner);
  }
  return box;
}

Vector2 middle_of(const Polygon& polygon) {
  Vector2 sum = Vector2::Zero();
  for (const Vector2& corner : polygon) sum += corner;
  return sum / static_cast<double>(polygon.size());
}

double heading_to(const Vector3& from, const Polygon& polygon) {
  const Vector2 offset = middle_of(polygon) - from.head<2>();
  return std::atan2(offset.y(), offset.x());
}

/// Over the zone's box, with the risks of the world.
world::GroundState ground_over(const Polygon& polygon, const world::GroundState& known,
                               double footprint) {
  const Box box = box_of(polygon);
  const Vector2 sides = box.high - box.low;
  double cell = std::min(footprint, std::max(1e-3, box.least_side()) / kCellsAcross);
  if (known.grid.size() > 0) cell = std::min(cell, known.grid.cell);
  world::GroundState ground;
  for (int i = 0; i < kFinerGrounds; ++i, cell /= 2) {
    cell = std::max(cell, std::sqrt(sides.prod() / static_cast<double>(kMostCells)));
    const auto cells = [&](double side) {
      return static_cast<std::size_t>(std::max(1.0, std::ceil(side / cell)));
    };
    ground.grid = {box.low.x(), box.low.y(), cell, cells(sides.x()), cells(sides.y())};
    ground.risk.clear();
    bool any = false;
    for (std::size_t at = 0; at < ground.grid.size(); ++at) {
      const Vector2 centre = ground.grid.centre(at);
      any = any || world::contains(polygon, centre);
      ground.risk.push_back(known.risk_at(centre));
    }
    if (any) break;
  }
  return ground;
}

/// Without the points nearer to the last one kept than `spacing`.
Way spaced(const Way& way, double spacing) {
  Way kept;
  for (const Vector3& point : way)
    if (kept.empty() || (point - kept.back()).head<2>().norm() >= spacing) kept.push_back(point);
  return kept;
}

/// Part of the zone that is nearer to some sample of the track than `reach`.
double seen_part(const Polygon& zone, const std::vector<Vector3>& track, std::size_t stride,
                 double reach) {
  const Box box = box_of(zone);
  const Vector2 step = (box.high - box.low) / kSamples;
  std::size_t all = 0, seen = 0;
  for (double i = 0.5; i < kSamples; ++i)
    for (double k = 0.5; k < kSamples; ++k) {
      const Vector2 at = box.low + Vector2(i * step.x(), k * step.y());
      if (!world::contains(zone, at)) continue;
      ++all;
      for (std::size_t t = 0; t < track.size(); t += stride)
        if ((track[t].head<2>() - at).squaredNorm() <= reach * reach) {
          ++seen;
          break;
        }
    }
  return all == 0 ? 1 : static_cast<double>(seen) / static_cast<double>(all);
}

}  // namespace

/// How long the zone was in sight during a flight.
class Refinery::Sight {
 public:
  Sight(const FlownWay& flown, const Polygon& zone, const Look& look) {
    Vector2 course = Vector2::Zero();
    for (std::size_t i = 0; i < flown.track.size(); ++i) {
      const Vector2 at = flown.track[i].head<2>();
      const Vector2 step = i > 0 ? Vector2(at - flown.track[i - 1].head<2>()) : course;
      if (step.norm() > kMoves) course = step.normalized();
      const double off =
          look.aim ? (*look.aim - at).norm() : distance_to(zone, at + look.ahead * course);
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

Answer<double> Refinery::footprint(const world::SensorModel& device, double height) const {
  if (height <= 0 || height >= device.range)
    return no(device.device + " reaches " + std::to_string(std::lround(device.range)) +
              " m, and would look from " + std::to_string(std::lround(height)) +
              " m over the ground");
  const double reach = std::sqrt(device.range * device.range - height * height);
  return std::min(reach, height * std::tan(device.aperture));
}

/// A device that looks down sees what is below; one that is tilted sees the ground ahead, as far as
/// its range lets it.
Refinery::Look Refinery::look_of(const world::SensorModel& device, double height,
                                 double footprint) {
  const double down = std::max(kSteepLook, -device.boresight_pitch);
  if (down > std::numbers::pi / 2 - kSteepLook) return {0, footprint, {}, footprint};
  const double slant = std::min(height / std::sin(down), device.range);
  const double ahead = std::sqrt(std::max(0.0, slant * slant - height * height));
  return {ahead, std::max(footprint, slant * std::tan(device.aperture)), {}, footprint};
}

world::World Refinery::world_of(const world::Zone& zone, const Vector3& from, double footprint,
                                double margin, const Counted& air) const {
  world::World local = world();
  local.ground = ground_over(zone.polygon, world().ground, footprint);
  local.volumes = closed(air);
  const bool inside =
      std::any_of(local.volumes.begin(), local.volumes.end(), [&](const auto& volume) {
        return distance_to(grown(volume, stray()).polygon, from.head<2>()) <= 0;
      });
  if (!inside)
    for (world::Volume& volume : local.volumes) volume = grown(volume, margin);
  return local;
}

Answer<Way> Refinery::planned_patrol(const world::World& world, const Vector3& from,
                                     const world::Zone& zone, double footprint,
                                     double seconds) const {
  refiners::PatrolQuery query;
  query.vehicle = cautious();
  query.zone = zone.polygon;
  query.start = from;
  query.heading = heading_to(from, zone.polygon);
  query.altitude = from.z() - gazetteer_.ground(from);
  query.footprint = footprint;
  query.duration = Duration::seconds(seconds);
  query.depart = origin_;
  auto refined = refine(query, refiners::Setting{world, budget_, seed_, nullptr});
  if (!refined) return no(refined.error().why);
  if (vehicle().hovers) return std::move(refined->task.way);
  return spaced(refined->task.way, kSpacing * vehicle().min_turn_radius);
}

/// The part of a way after which the zone was in sight for so long, as the autopilot flies it and
/// as quick as that may be; nothing, and how many times as long it would have to be.
std::optional<Way> Refinery::filled(const Way& way, const world::Zone& zone, const Look& look,
                                    double seconds, double& longer) const {
  if (way.size() < 2) return std::nullopt;
  const Times times = flight_times(way, vehicle(), world().wind);
  const double needed = seconds + times.expected - times.least;
  Pose start = poses_at(way.front(), vehicle()).front();
  start.heading = heading_to(way.front(), zone.polygon);
  const Way rest(way.begin() + 1, way.end());
  const FlownWay flown = fly_way(start, rest, vehicle(), world().wind);
  const Sight sight(flown, zone.polygon, look);
  // Turns beyond the zone are part of a patrol of one that cannot hover, within reason.
  const double share = vehicle().hovers ? 1 : kTurningShare;
  const auto done = [&](double at) {
    return std::min(sight.since_first(at), sight.until(at) / share);
  };
  longer = needed / std::max(done(flown.seconds), 1e-3);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const double more = done(flown.passages[i]) - needed;
    if (more < 0) continue;
    Way part(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(i) + 2);
    const double leg = flown.passages[i] - (i > 0 ? flown.passages[i - 1] : 0);
    // Of one that hovers the last leg may end anywhere.
    if (vehicle().hovers && more < leg) part.back() += more / leg * (way[i] - way[i + 1]);
    return part;
  }
  return std::nullopt;
}

std::vector<Way> Refinery::rounds(const Vector3& from, const world::Zone& zone, double footprint,
                                  const Counted& air) const {
  const double radius =
      vehicle().hovers ? 2 * reaching_distance(vehicle(), world().wind)
                       : std::clamp(kInSight * footprint, kTightest * vehicle().min_turn_radius,
                                    vehicle().orbit_radius);
  const Vector2 middle = middle_of(zone.polygon);
  const double height = from.z() - gazetteer_.ground(from);
  const double towards = std::atan2(from.y() - middle.y(), from.x() - middle.x());
  const Volumes volumes = closed(air);
  const auto is_open = [&](const Vector3& at) {
    return world().terrain.contains(at.x(), at.y()) &&
           std::none_of(volumes.begin(), volumes.end(),
                        [&](const auto& volume) { return is_near(volume, at, stray()); });
  };
  const auto round = [&](int corners, double turned) {
    Way way;
    for (int i = 0; i < corners; ++i) {
      const double angle = towards + turned + 2 * std::numbers::pi * i / corners;
      const Vector2 at = middle + radius * Vector2(std::cos(angle), std::sin(angle));
      way.emplace_back(at.x(), at.y(), world().terrain.elevation(at.x(), at.y()) + height);
    }
    return way;
  };
  std::vector<Way> rounds = {round(kSides, 0)};
  for (int i = 0; vehicle().hovers && i < kWays; ++i)
    rounds.push_back(round(2, std::numbers::pi * i / kWays));
  std::erase_if(rounds,
                [&](const Way& way) { return !std::all_of(way.begin(), way.end(), is_open); });
  return rounds;
}

/// Nothing where there is no way to it.
std::optional<Way> Refinery::again_and_again(const Vector3& from, const Way& round, double seconds,
                                             const Counted& counted) {
  Way way = {from};
  if (!closed(counted).empty()) {
    const auto air = airspace(counted);
    if (!air) return std::nullopt;
    if ((*air)->is_free(from)) {
      auto there = way_through(**air, from, round.front());
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

Answer<Motion> Refinery::patrol(const Vector3& from, const world::Zone& zone,
                                const world::SensorModel& device, double seconds,
                                const Departure& when) {
  auto motion = kept_clear(from, when, seconds, [&](const Counted& air) {
    return patrol_in(air, from, zone, device, seconds);
  });
  if (motion && !when.suited && !stays_open(from, when, motion->times.most))
    return no("the air where it begins closes meanwhile");
  return motion;
}

Answer<Motion> Refinery::patrol_in(const Counted& air, const Vector3& from, const world::Zone& zone,
                                   const world::SensorModel& device, double seconds) {
  const double height = from.z() - gazetteer_.ground(from);
  const auto width = footprint(device, height);
  if (!width) return no(width.error());
  const Look look = look_of(device, height, *width);
  auto motion = patrolled(air, from, zone, look, seconds);
  const double approach = distance_to(zone.polygon, from.head<2>()) / vehicle().cruise_speed;
  const bool serves = motion && motion->times.expected <= kOutOfSight * (seconds + approach);
  if (serves || look.ahead <= 0 || !device.gimballed) return motion;
  // Ahead of it there is little but what lies beyond a small zone: its middle can be aimed at.
  const Vector2 middle = middle_of(zone.polygon);
  const double reach = std::sqrt(device.range * device.range - height * height);
  auto aimed = patrolled(air, from, zone, {0, reach, middle, *width}, seconds);
  if (!aimed || (motion && motion->times.expected <= aimed->times.expected)) return motion;
  const Vector3 at(middle.x(), middle.y(), 0);
  aimed->aim = Vector3(middle.x(), middle.y(), gazetteer_.ground(at));
  return aimed;
}

/// Lanes; with more room where closed air has too little for its turns. Over a zone that is smaller
/// than what it strays, and where lanes have no room: rounds.
Answer<Motion> Refinery::patrolled(const Counted& air, const Vector3& from, const world::Zone& zone,
                                   const Look& look, double seconds) {
  auto lanes = in_lanes(air, from, zone, look, seconds, stray());
  if (!lanes && !closed(air).empty()) {
    auto roomy = in_lanes(air, from, zone, look, seconds, stray() + swing());
    if (roomy) return roomy;
  }
  if (lanes) return lanes;
  auto motion = in_rounds(air, from, zone, look, seconds);
  return motion ? std::move(motion) : std::move(lanes);
}

Answer<Motion> Refinery::in_lanes(const Counted& air, const Vector3& from, const world::Zone& zone,
                                  const Look& look, double seconds, double margin) const {
  const world::World local = world_of(zone, from, look.width, margin, air);
  const Volumes volumes = closed(air);
  const double in_sight =
      seconds + distance_to(zone.polygon, from.head<2>()) / vehicle().cruise_speed;
  double duration = in_sight, longer = 1;
  for (int i = 0; i < kLongerPatrols && duration <= kLongestPatrol * in_sight; ++i) {
    const auto way = planned_patrol(local, from, zone, look.width, duration);
    if (!way) return no(way.error());
    if (auto part = filled(*way, zone, look, seconds, longer)) {
      if (met(*part, volumes)) return no("closed air is too near for its turns");
      return flown(std::move(*part));
    }
    duration *= std::clamp(1.05 * longer, 1.1, kLongest);
  }
  return no("its time cannot be filled");
}

Answer<Motion> Refinery::in_rounds(const Counted& air, const Vector3& from, const world::Zone& zone,
                                   const Look& look, double seconds) {
  const double approach = distance_to(zone.polygon, from.head<2>()) / vehicle().cruise_speed;
  for (const Way& round : rounds(from, zone, look.width, air)) {
    double duration = seconds + approach, longer = 1;
    for (int i = 0; i < kLongerPatrols; ++i, duration *= std::clamp(1.05 * longer, 1.1, kLongest)) {
      const auto way = again_and_again(from, round, duration, air);
      if (!way) break;
      auto part = filled(*way, zone, look, seconds, longer);
      if (!part) continue;
      if (met(*part, closed(air))) break;
      return flown(std::move(*part));
    }
  }
  return no("there is no room for rounds over it");
}

/// Lanes as they are flown: by a vehicle that cannot hover from a place behind the first, which it
/// comes to from anywhere; each from a little before to a little beyond the zone, since way-points
/// count as reached a little before, and with points in between that keep it on its lane.
Answer<Refinery::Lanes> Refinery::planned_sweep(const world::World& world, const Vector3& from,
                                                const world::Zone& zone,
                                                const world::SensorModel& device,
                                                double overlap) const {
  refiners::CoverageQuery query;
  query.vehicle = cautious();
  query.area = zone.polygon;
  query.altitude = std::min(gazetteer_.knowledge().altitude, vehicle().ceiling);
  const auto width = footprint(device, query.altitude);
  if (!width) return no(width.error());
  query.swath = 2 * std::max(*width / 2, *width - overlap * world::tracking_spread(vehicle()));
  query.start = gazetteer_.flown_to(from);
  query.depart = origin_;
  auto refined = refine(query, refiners::Setting{world, budget_, seed_, nullptr});
  if (!refined) return no(refined.error().why);
  Lanes lanes{lanes_flown(refined->task, world), 1};
  const auto stride =
      std::max<std::size_t>(1, static_cast<std::size_t>(device.period.to_seconds() / kTrackStep));
  const double reach = *width - kSureShare * world::tracking_spread(vehicle());
  const Way rest(lanes.way.begin() + 1, lanes.way.end());
  for (const Pose& pose : poses_at(lanes.way.front(), vehicle())) {
    const FlownWay flown = fly_way(pose, rest, vehicle(), world.wind);
    lanes.seen = std::min(lanes.seen, seen_part(zone.polygon, flown.track, stride, reach));
  }
  return lanes;
}

Way Refinery::lanes_flown(const refiners::Coverage& task, const world::World& world) const {
  const auto is_open = [&](const Vector3& at) {
    return world.terrain.contains(at.x(), at.y()) &&
           std::none_of(world.volumes.begin(), world.volumes.end(),
                        [&](const auto& volume) { return is_near(volume, at, 1e-3); });
  };
  const double beyond = reaching_distance(vehicle(), world.wind);
  const double spacing = kLaneSpacing * vehicle().min_turn_radius;
  const auto same = [](const Vector3& at, const Vector2& end) {
    return (at.head<2>() - end).norm() < 1e-6;
  };
  Way way;
  std::size_t lane = 0, arc = 0;  // `arc`: where the turn into the lane begins
  bool on_lane = false;
  // A point of an arc that is missed would be come back to.
  const double apart = vehicle().hovers ? 0 : kSpacing * vehicle().min_turn_radius;
  for (const Vector3& point : task.way) {
    if (lane == task.lanes.size()) break;
    const Vector2 along = (task.lanes[lane].to - task.lanes[lane].from).normalized();
    const Vector3 ahead(along.x(), along.y(), 0);
    if (!on_lane && same(point, task.lanes[lane].from)) {
      on_lane = true;
      const Vector3 early = point - beyond * ahead;
      if (way.empty() && !vehicle().hovers) {
        double back = kRunIn * vehicle().min_turn_radius + beyond;
        while (back > beyond && !(is_open(point - back * ahead) && has_room(point - back * ahead)))
          back -= beyond;
        way.push_back(point - back * ahead);
        arc = 1;
      }
      const Vector3 first = is_open(early) ? early : point;
      while (way.size() > arc && (way.back() - first).head<2>().norm() < apart) way.pop_back();
      way.push_back(first);
    } else if (on_lane && same(point, task.lanes[lane].to)) {
      if (!vehicle().hovers)
        for (double s = spacing; s + spacing < (point - way.back()).norm();)
          way.push_back(way.back() + s * (point - way.back()).normalized());
      const Vector3 late = point + beyond * ahead;
      way.push_back(is_open(late) ? late : point);
      on_lane = false;
      ++lane;
      arc = way.size();
    } else if (!way.empty() && (way.back() - point).head<2>().norm() >= apart) {
      way.push_back(point);
    }
  }
  return way;
}

Answer<Refinery::Lanes> Refinery::best_sweep(const Counted& air, const Vector3& from,
                                             const world::Zone& zone,
                                             const world::SensorModel& device,
                                             double margin) const {
  const world::World local = world_of(zone, from, 1e9, margin, air);
  Lanes best;
  std::string why = "nothing of it would be seen";
  for (const double overlap : {1.0, 2.0, 3.0, 4.0}) {
    auto lanes = planned_sweep(local, from, zone, device, overlap);
    if (!lanes) {
      why = lanes.error();
      break;
    }
    if (lanes->seen > best.seen) best = std::move(*lanes);
    if (best.seen >= kSeenEnough) break;
  }
  if (best.way.empty()) return no(why);
  return best;
}

Answer<Motion> Refinery::sweep(const Vector3& from, const world::Zone& zone,
                               const world::SensorModel& device, const Departure& when) const {
  return kept_clear(from, when, 0,
                    [&](const Counted& air) { return sweep_in(air, from, zone, device); });
}

Answer<Motion> Refinery::sweep_in(const Counted& air, const Vector3& from, const world::Zone& zone,
                                  const world::SensorModel& device) const {
  const Volumes volumes = closed(air);
  const auto motion = [&](Lanes lanes) {
    Motion all = flown(std::move(lanes.way));
    all.seen = lanes.seen;
    return all;
  };
  auto lanes = best_sweep(air, from, zone, device, stray());
  if (!lanes) return no(lanes.error());
  if (!met(lanes->way, volumes)) return motion(std::move(*lanes));
  lanes = best_sweep(air, from, zone, device, stray() + swing());
  if (lanes && lanes->seen >= kSeenEnough && !met(lanes->way, volumes))
    return motion(std::move(*lanes));
  return no("closed air is too near for its turns");
}

}  // namespace skein::supervisor
