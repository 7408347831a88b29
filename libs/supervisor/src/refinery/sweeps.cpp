// SPDX-License-Identifier: Apache-2.0
#include "refinery/sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "flight/autopilot.hpp"
#include "flight/closed_air.hpp"
#include "refinery/zone_shapes.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/world/steering.hpp"

namespace skein::supervisor {

using refiners::Way;
using world::Polygon;
using world::Vector2;
using world::Vector3;

namespace {

constexpr double kSpacing = 2;  // turn radii between points of arcs: none is circled then
constexpr double kPlastic = 0.7548776662466927;  // 1 / 1.3247…, the root of x³ = x + 1
// Of a zone's box, to see what is seen of it: of a gap of 1 % some ten to twenty.
constexpr int kSamples = 2400;
constexpr double kRunIn = 3;  // radii of its widest turn before the first lane
// Waiting circles' radii, straight before a lane that is taken up again.
constexpr double kRunInAgain = 2;
constexpr double kLaneSpacing = 2.5;  // turn radii between way-points along lanes
constexpr int kJoined = 2;            // way-points that bring one that hovers back on its lane
constexpr double kMostCells = 200;    // along a side of its box
constexpr double kSeenEnough = 0.998;
constexpr double kSeenMost = 0.99;         // with less, lanes are flown nearer to each other
constexpr double kWorthMoreLanes = 0.004;  // of a zone
constexpr double kSureShare = 1.4;         // deviations by which it may see less far

/// How far to the side of it a sensor sees for sure, over level ground `altitude` below it [m].
struct Reach {
  double width, altitude, unsure;

  /// Where the ground is higher it sees less of it.
  double over(double height) const { return width * std::min(1.0, height / altitude) - unsure; }
};

/// Places of a track in square cells over a box and around it: what is within a cell's side of a
/// place in the box lies in the nine cells around that.
class TrackCells {
 public:
  TrackCells(const Box& box, double side, const std::vector<Vector3>& track, std::size_t stride)
      : low_(box.low),
        side_(side),
        columns_(1 + cell(box.high.x() - box.low.x()) + 1),
        rows_(1 + cell(box.high.y() - box.low.y()) + 1),
        cells_(static_cast<std::size_t>(columns_ * rows_)) {
    for (std::size_t t = 0; t < track.size(); t += stride) {
      const long x = cell(track[t].x() - low_.x()), y = cell(track[t].y() - low_.y());
      if (x < 0 || y < 0 || x >= columns_ || y >= rows_) continue;
      cells_[static_cast<std::size_t>(y * columns_ + x)].push_back(track[t]);
    }
  }

  bool any_around(const Vector2& at, const auto& is_wanted) const {
    const long x = cell(at.x() - low_.x()), y = cell(at.y() - low_.y());
    for (long row = y - 1; row <= y + 1; ++row) {
      for (long column = x - 1; column <= x + 1; ++column) {
        const auto& one = cells_[static_cast<std::size_t>(row * columns_ + column)];
        if (std::any_of(one.begin(), one.end(), is_wanted)) return true;
      }
    }
    return false;
  }

 private:
  /// The first begins a side before the box.
  long cell(double offset) const { return 1 + static_cast<long>(std::floor(offset / side_)); }

  Vector2 low_;
  double side_;
  long columns_, rows_;
  std::vector<std::vector<Vector3>> cells_;
};

/// Part of the zone that is within reach of some sample of the track. Of places that lie in no rows
/// (the additive sequence of the plastic number): a narrow strip between two lanes is not missed.
double seen_part(const Polygon& zone, const world::Terrain& terrain,
                 const std::vector<Vector3>& track, std::size_t stride, const Reach& reach) {
  const Box box = box_of(zone);
  const Vector2 size = box.high - box.low;
  const double side = std::max(reach.width, size.maxCoeff() / kMostCells);
  const TrackCells cells(box, side, track, stride);
  std::size_t all = 0, seen = 0;
  for (int i = 0; i < kSamples; ++i) {
    const Vector2 at = box.low + Vector2(std::fmod(0.5 + kPlastic * i, 1) * size.x(),
                                         std::fmod(0.5 + kPlastic * kPlastic * i, 1) * size.y());
    if (!world::contains(zone, at)) continue;
    ++all;
    const double ground = terrain.elevation(at.x(), at.y());
    const bool is_seen = cells.any_around(at, [&](const Vector3& from) {
      return (from.head<2>() - at).norm() <= reach.over(from.z() - ground);
    });
    seen += is_seen ? 1 : 0;
  }
  return all == 0 ? 1 : static_cast<double>(seen) / static_cast<double>(all);
}

/// The radius of a turn over ground where the wind pushes it most [m].
double widest_turn(const world::VehicleModel& vehicle, const world::Wind& wind) {
  const double pushed = 1 + wind.speed / vehicle.cruise_speed;
  return pushed * pushed * vehicle.min_turn_radius;
}

/// Where it turns by more than that it goes over to the next lane.
constexpr double kLaneTurn = 0.5;  // [rad]

bool turns_at(const Way& way, std::size_t i) {
  const Vector2 before = (way[i] - way[i - 1]).head<2>(), after = (way[i + 1] - way[i]).head<2>();
  const double cross = before.x() * after.y() - before.y() * after.x();
  return std::abs(std::atan2(cross, before.dot(after))) > kLaneTurn;
}

/// Of the way-points between its ends the one nearest to that share of its length; of those at
/// which it turns, if there are any.
std::optional<std::size_t> cut_of(const Way& way, double share) {
  std::optional<std::size_t> best;
  const double wanted = share * refiners::length_of(way);
  double length = 0, off = 0;
  bool turning = false;
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    length += (way[i] - way[i - 1]).norm();
    const bool turns = turns_at(way, i);
    if (best && turning && !turns) continue;
    if (best && turning == turns && std::abs(length - wanted) >= off) continue;
    best = i;
    off = std::abs(length - wanted);
    turning = turns;
  }
  return best;
}

}  // namespace

double swath_of(double footprint, const world::VehicleModel& vehicle, double overlap) {
  return 2 * std::max(footprint / 2, footprint - overlap * world::tracking_spread(vehicle));
}

double footprint_of(double swath, const world::VehicleModel& vehicle, double overlap) {
  return std::min(swath, swath / 2 + overlap * world::tracking_spread(vehicle));
}

/// Lanes as they are flown: by a vehicle that cannot hover from a place behind the first, which it
/// comes to from anywhere; each from a little before to a little beyond the zone, since way-points
/// count as reached a little before, and with points in between that keep it on its lane.
Answer<Sweeps::Lanes> Sweeps::planned(const world::World& world, const Vector3& from,
                                      const world::Zone& zone, const world::SensorModel& device,
                                      const Care& care) const {
  refiners::CoverageQuery query;
  query.vehicle = air_.cautious();
  query.area = zone.polygon;
  query.altitude = std::min(gazetteer().knowledge().altitude, vehicle().ceiling);
  const auto width = footprint(device, query.altitude);
  if (!width) return no(width.error());
  query.swath = care.share * swath_of(*width, vehicle(), care.overlap);
  query.start = gazetteer().flown_to(from);
  query.depart = air_.origin();
  auto refined = refine(query, air_.setting(world));
  if (!refined) return no(refined.error().why);
  Lanes lanes{lanes_flown(refined->task, world, care.joins), 1};
  const auto stride =
      std::max<std::size_t>(1, static_cast<std::size_t>(device.period.to_seconds() / kTrackStep));
  const Reach reach{*width, query.altitude, kSureShare * world::tracking_spread(vehicle())};
  const Way rest(lanes.way.begin() + 1, lanes.way.end());
  for (const Pose& pose : poses_at(lanes.way.front(), vehicle())) {
    const FlownWay flown = fly_way(pose, rest, vehicle(), world.wind);
    lanes.seen =
        std::min(lanes.seen, seen_part(zone.polygon, world.terrain, flown.track, stride, reach));
  }
  return lanes;
}

// One that hovers swings out where it turns with some speed, and joins its lane only at the far end
// of it if it aims at that: where that leaves gaps, points behind the turn bring it back.
void Sweeps::fly_along(Way& way, const Vector3& to, bool joins) const {
  const double swing = vehicle().cruise_speed * vehicle().cruise_speed / vehicle().acceleration;
  const double spacing = vehicle().hovers ? swing : kLaneSpacing * vehicle().min_turn_radius;
  int left = vehicle().hovers ? (joins ? kJoined : 0) : std::numeric_limits<int>::max();
  for (; left > 0 && 2 * spacing < (to - way.back()).norm(); --left)
    way.push_back(way.back() + spacing * (to - way.back()).normalized());
}

Way Sweeps::lanes_flown(const refiners::Coverage& task, const world::World& world,
                        bool joins) const {
  const auto is_open = [&](const Vector3& at) {
    return world.terrain.contains(at.x(), at.y()) &&
           std::none_of(world.volumes.begin(), world.volumes.end(),
                        [&](const auto& volume) { return is_near(volume, at, 1e-3); });
  };
  const double beyond = world::reaching_distance(vehicle(), world.wind);
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
        double back = kRunIn * widest_turn(vehicle(), world.wind) + beyond;
        while (back > beyond &&
               !(is_open(point - back * ahead) && air_.has_room(point - back * ahead)))
          back -= beyond;
        way.push_back(point - back * ahead);
        arc = 1;
      }
      const Vector3 first = is_open(early) ? early : point;
      while (way.size() > arc && (way.back() - first).head<2>().norm() < apart) way.pop_back();
      way.push_back(first);
    } else if (on_lane && same(point, task.lanes[lane].to)) {
      fly_along(way, point, joins);
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

Answer<Sweeps::Lanes> Sweeps::best(const Counted& air, const Vector3& from, const world::Zone& zone,
                                   const world::SensorModel& device, double margin) const {
  const world::World local = air_.over(zone, from, 1e9, margin, air);
  Lanes best;
  std::string why = "nothing of it would be seen";
  for (const bool joins : {false, true}) {
    if (joins && (best.seen >= (swings_ ? kSeenMost : kSeenEnough) || !vehicle().hovers)) break;
    for (const double overlap :
         swings_ ? std::vector{kSharedOverlap, 4.0} : std::vector{1.0, 2.0, 3.0, 4.0}) {
      auto lanes = planned(local, from, zone, device, {overlap, joins});
      if (!lanes) {
        why = lanes.error();
        break;
      }
      if (lanes->seen > best.seen) best = std::move(*lanes);
      if (best.seen >= kSeenEnough) break;
    }
  }
  if (best.way.empty()) return no(why);
  return swings_ || best.seen >= kSeenMost ? best
                                           : narrowed(std::move(best), local, from, zone, device);
}

Sweeps::Lanes Sweeps::narrowed(Lanes wide, const world::World& world, const Vector3& from,
                               const world::Zone& zone, const world::SensorModel& device) const {
  Lanes best = std::move(wide);
  for (const double share : {0.85, 0.7, 0.55}) {
    if (best.seen >= kSeenMost) break;
    auto lanes = planned(world, from, zone, device, {4, vehicle().hovers, share});
    if (lanes && lanes->seen > best.seen + kWorthMoreLanes) best = std::move(*lanes);
  }
  return best;
}

Answer<Motion> Sweeps::over(const Vector3& from, const world::Zone& zone,
                            const world::SensorModel& device, const Departure& when) const {
  if (vehicle().ground) return no("it keeps to the ground, and sweeps no zone");
  return air_.kept_clear(from, when, 0,
                         [&](const Counted& air) { return over_in(air, from, zone, device); });
}

Answer<Motion> Sweeps::over_in(const Counted& air, const Vector3& from, const world::Zone& zone,
                               const world::SensorModel& device) const {
  const TimedAir::Volumes volumes = air_.closed(air);
  const auto motion = [&](Lanes lanes) {
    Motion all = ways_.flown(std::move(lanes.way));
    all.seen = lanes.seen;
    return all;
  };
  // Where it begins counts too: nobody is there yet.
  const auto meets = [&](const Way& way) {
    return air_.met(way, volumes) ||
           std::any_of(volumes.begin(), volumes.end(),
                       [&](const auto& volume) { return is_near(volume, way.front(), 0); });
  };
  auto lanes = best(air, from, zone, device, air_.stray());
  if (!lanes) return no(lanes.error());
  if (!meets(lanes->way)) return motion(std::move(*lanes));
  lanes = best(air, from, zone, device, air_.stray() + air_.swing());
  if (lanes && lanes->seen >= kSeenEnough && !meets(lanes->way)) return motion(std::move(*lanes));
  return no("closed air is too near for its turns");
}

Answer<Motion> Sweeps::rest(const Vector3& from, const Way& way, const world::SensorModel& device,
                            const world::SensorModel& before, const Departure& when) {
  return air_.kept_clear(
      from, when, 0, [&](const Counted& counted) { return rest_in(counted, way, device, before); });
}

Answer<Motion> Sweeps::rest_in(const Counted& counted, const Way& way,
                               const world::SensorModel& device, const world::SensorModel& before) {
  const auto air = air_.airspace(counted);
  if (!air) return no(air.error());
  const double height = way.front().z() - gazetteer().ground(way.front());
  const auto width = footprint(device, height), needed = footprint(before, height);
  if (!width) return no(width.error());
  if (needed && *width < *needed) return no(device.device + " sees less than " + before.device);
  for (std::size_t i = 1; i < way.size(); ++i)
    if (!(*air)->is_free(way[i - 1], way[i])) return no("air on what is left of it is closed");
  if (vehicle().hovers) return ways_.flown(way);
  // It comes to the first lane in its direction.
  const Vector3 along = (way[1] - way[0]).normalized();
  const Vector3 before_it = way[0] - kRunInAgain * vehicle().orbit_radius * along;
  Way with_run_in = {before_it};
  with_run_in.insert(with_run_in.end(), way.begin(), way.end());
  return ways_.flown((*air)->is_free(before_it, way[0]) ? std::move(with_run_in) : way);
}

std::optional<Sweeps::Parts> Sweeps::parted(const Way& way, double share) const {
  const auto cut = cut_of(way, share);
  if (!cut) return std::nullopt;
  const auto at = way.begin() + static_cast<std::ptrdiff_t>(*cut);
  return Parts{ways_.flown({way.begin(), at + 1}), {at, way.end()}};
}

}  // namespace skein::supervisor
