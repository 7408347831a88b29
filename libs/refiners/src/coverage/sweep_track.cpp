// SPDX-License-Identifier: Apache-2.0
#include "coverage/sweep_track.hpp"

#include <algorithm>
#include <cmath>

#include "common/circles.hpp"
#include "common/ground_profile.hpp"
#include "skein/refiners/flyable.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;

/// Joins lanes and places, and counts what ways around obstacles take more.
class Tracer {
 public:
  Tracer(const TurnModel& model, const Obstacles& obstacles)
      : model_(model), obstacles_(obstacles) {}

  void go(const Vector2& point) {
    if (points.empty() || (points.back() - point).norm() > 1e-9) points.push_back(point);
  }
  /// By a vehicle that hovers.
  void move(const Vector2& to) {
    const Vector2 from = points.back();
    if (!is_closed({from, to})) return go(to);
    const auto around = way_around(obstacles_, from, to, kMargin);
    if (!around) return go(to);
    for (std::size_t i = 1; i < around->size(); ++i) {
      added += model_.along(((*around)[i] - (*around)[i - 1]).norm());
      go((*around)[i]);
    }
    added -= model_.along((to - from).norm());
  }
  /// By one that does not; a heading that is absent may be any.
  void curve(const DubinsCurve& shortest, std::optional<double> heading_from,
             std::optional<double> heading_to) {
    std::vector<Vector2> sampled = shortest.sampled(kTurnTolerance);
    if (is_closed(sampled)) {
      if (auto around = flown_around(sampled, heading_from, heading_to)) {
        for (std::size_t i = 1; i < around->size(); ++i)
          added += ((*around)[i] - (*around)[i - 1]).norm() / model_.speed();
        added -= shortest.length() / model_.speed();
        sampled = std::move(*around);
      }
    }
    for (const Vector2& point : sampled) go(point);
  }

  std::vector<Vector2> points;
  double added = 0;

 private:
  static constexpr double kMargin = 1;  // [m]

  bool is_closed(const std::vector<Vector2>& line) const {
    if (obstacles_.outlines.empty()) return false;
    for (std::size_t i = 1; i < line.size(); ++i)
      if (!obstacles_.is_free(line[i - 1], line[i])) return true;
    return false;
  }

  /// With more and more room for the turns around corners.
  std::optional<std::vector<Vector2>> flown_around(const std::vector<Vector2>& shortest,
                                                   std::optional<double> heading_from,
                                                   std::optional<double> heading_to) const {
    FlyableQuery query;
    query.heading_from = heading_from;
    query.heading_to = heading_to;
    query.speed = model_.speed();
    query.tolerance = kTurnTolerance;
    query.is_free = [&](const Vector3& a, const Vector3& b) {
      return obstacles_.is_free(a.head<2>(), b.head<2>());
    };
    for (const double room : {0.5, 1.0, 2.0}) {
      const auto around =
          way_around(obstacles_, shortest.front(), shortest.back(), room * model_.radius());
      if (!around) continue;
      query.corners.clear();
      for (const Vector2& corner : *around) query.corners.emplace_back(corner.x(), corner.y(), 0);
      const auto flyable = make_flyable(query, model_.vehicle());
      if (!flyable) continue;
      std::vector<Vector2> level;
      for (const Vector3& point : *flyable) level.emplace_back(point.x(), point.y());
      return level;
    }
    return std::nullopt;
  }

  const TurnModel& model_;
  const Obstacles& obstacles_;
};

/// A point of a track, seen from the side.
struct Station {
  Vector2 at = Vector2::Zero();
  double along = 0;   ///< from the beginning of the track [m]
  double ground = 0;  ///< ENU z [m]
  double z = 0;
  bool corner = false;  ///< of the track; else put in between
};

struct Slopes {
  double up, down;  ///< metres per metre
};

/// The corners of the track, and stations in between so that no ground stands out.
class Stations {
 public:
  Stations(const Track& track, const world::Terrain& terrain) {
    for (std::size_t i = 0; i < track.points.size(); ++i) {
      const Vector2& at = track.points[i];
      if (i > 0) add_between(track.points[i - 1], at, terrain);
      add(at, terrain.elevation(at.x(), at.y()), true);
      if (i == track.first) first = all.size() - 1;
      if (i == track.last) last = all.size() - 1;
    }
  }

  std::vector<Station> all;
  std::size_t first = 0, last = 0;

 private:
  void add(const Vector2& at, double ground, bool corner) {
    Station station;
    station.at = at;
    station.along = all.empty() ? 0 : all.back().along + (at - all.back().at).norm();
    station.ground = ground;
    station.corner = corner;
    all.push_back(station);
  }
  void add_between(const Vector2& from, const Vector2& to, const world::Terrain& terrain) {
    for (const GroundPoint& point : ground_along(terrain, from, to))
      if (point.part > 0 && point.part < 1)
        add(from + (to - from) * point.part, point.ground, false);
  }
};

/// Raises what is too low for the slopes from its neighbours to be flown.
void soften(std::vector<Station>& stations, const Slopes& slopes) {
  for (std::size_t i = stations.size() - 1; i-- > 0;) {
    const double run = stations[i + 1].along - stations[i].along;
    stations[i].z = std::max(stations[i].z, stations[i + 1].z - slopes.up * run);
  }
  for (std::size_t i = 1; i < stations.size(); ++i) {
    const double run = stations[i].along - stations[i - 1].along;
    stations[i].z = std::max(stations[i].z, stations[i - 1].z - slopes.down * run);
  }
}

/// Lets the stations from `far` (start or end) to `near` (a lane) rise or sink evenly from where
/// that is, or as much of it as the slopes allow, half as high as both at least.
void lead(std::vector<Station>& stations, std::size_t far, std::size_t near, double z,
          const Slopes& from_far) {
  const double run = std::abs(stations[near].along - stations[far].along);
  const double lane = stations[near].z;
  const double altitude = lane - stations[near].ground;
  const double least = std::clamp((z - stations[far].ground) / 2, 0.0, altitude / 2);
  const double begin = std::clamp(z, lane - from_far.up * run, lane + from_far.down * run);
  const std::size_t low = std::min(far, near), high = std::max(far, near);
  for (std::size_t i = low; i <= high; ++i) {
    if (i == near) continue;
    const double part = std::abs(stations[i].along - stations[far].along) / run;
    stations[i].z = std::max(begin + (lane - begin) * part, stations[i].ground + least);
  }
}

/// By how much a straight line at that height is wrong at a station: what it misses it by, or as if
/// by more than `tolerance` where it leaves less than half of its height over the ground.
double miss(const Station& station, double z, double tolerance) {
  const double off = std::abs(station.z - z);
  const double low = (station.z + station.ground) / 2 - z;
  return low > 1e-9 ? std::max(off, tolerance + low) : off;
}

/// Keeps of the stations between two corners those that a straight line would miss by more than
/// `tolerance`, or pass too low. Source: Douglas and Peucker 1973.
void keep_bends(std::vector<Station>& stations, double tolerance) {
  std::vector<std::pair<std::size_t, std::size_t>> spans;
  std::size_t before = 0;
  for (std::size_t i = 1; i < stations.size(); ++i)
    if (stations[i].corner) {
      spans.emplace_back(before, i);
      before = i;
    }
  while (!spans.empty()) {
    const auto [a, b] = spans.back();
    spans.pop_back();
    const double run = stations[b].along - stations[a].along;
    double worst = tolerance;
    std::size_t bend = b;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double part = (stations[i].along - stations[a].along) / run;
      const double off =
          miss(stations[i], stations[a].z + part * (stations[b].z - stations[a].z), tolerance);
      if (off <= worst) continue;
      worst = off;
      bend = i;
    }
    if (bend == b) continue;
    stations[bend].corner = true;
    spans.emplace_back(a, bend);
    spans.emplace_back(bend, b);
  }
}

/// From `way.back()` to another height over the same place.
void change_height(Way& way, double z, const Vector2& ahead, const CircleRule& rule,
                   const world::Terrain& terrain, const world::VehicleModel& vehicle) {
  const Vector3 at = way.back();
  if (std::abs(z - at.z()) < 1e-6) return;
  if (vehicle.hovers)
    way.emplace_back(at.x(), at.y(), z);
  else
    add_circles(way, z, ahead, rule, terrain);
}

Vector2 unit(const Vector2& from, const Vector2& to) {
  const double length = (to - from).norm();
  return length > 0 ? Vector2((to - from) / length) : Vector2(Vector2::UnitX());
}

}  // namespace

Track track_of(const Sweep& sweep, const SweepEnds& ends, const TurnModel& model,
               const Obstacles& obstacles) {
  Tracer tracer(model, obstacles);
  Track track;
  if (ends.start) {
    tracer.go(*ends.start);
    const Pass& first = sweep.passes.front();
    if (model.hovers())
      tracer.move(first.from);
    else
      tracer.curve(arrival(*ends.start, first.begin(), model.radius()), std::nullopt,
                   first.heading);
  }
  for (std::size_t i = 0; i < sweep.passes.size(); ++i) {
    const Pass& pass = sweep.passes[i];
    if (i > 0) {
      const Pass& before = sweep.passes[i - 1];
      if (model.hovers())
        tracer.move(pass.from);
      else
        tracer.curve(DubinsCurve::shortest(before.end(), pass.begin(), model.radius()),
                     before.heading, pass.heading);
    }
    tracer.go(pass.from);
    if (i == 0) track.first = tracer.points.size() - 1;
    tracer.go(pass.to);
  }
  track.last = tracer.points.size() - 1;
  if (ends.end) {
    const Pass& last = sweep.passes.back();
    if (model.hovers())
      tracer.move(*ends.end);
    else
      tracer.curve(departure(last.end(), *ends.end, model.radius()), last.heading, std::nullopt);
    tracer.go(*ends.end);
    if (tracer.points.size() > track.last + 1) tracer.points.back() = *ends.end;
  }
  track.points = std::move(tracer.points);
  track.seconds = sweep.seconds + tracer.added;
  return track;
}

double least_lead(double altitude, double height) {
  return std::max(0.0, std::min(altitude, height) / 4);
}

Way raised(const Track& track, const Profile& profile, const world::VehicleModel& vehicle,
           const world::Terrain& terrain) {
  const Slopes slopes{profile.steeper * vehicle.climb_rate / profile.speed,
                      profile.steeper * vehicle.descent_rate / profile.speed};
  Stations stations(track, terrain);
  std::vector<Station>& all = stations.all;
  for (Station& station : all) station.z = station.ground + profile.altitude;
  const bool from_start = profile.start && stations.first > 0;
  const bool to_end = profile.end && stations.last + 1 < all.size();
  soften(all, slopes);
  if (from_start) lead(all, 0, stations.first, *profile.start, slopes);
  if (to_end) lead(all, all.size() - 1, stations.last, *profile.end, {slopes.down, slopes.up});
  if (from_start || to_end) soften(all, slopes);
  keep_bends(all, profile.tolerance);

  Way way;
  const auto circles = [&](double z, const Station& end) {
    const double low = std::min(z, way.back().z());
    return CircleRule{z > way.back().z() ? slopes.up : slopes.down, vehicle.min_turn_radius,
                      least_lead(profile.altitude, low - end.ground)};
  };
  const auto at = [&](std::size_t i) { return all[i].at; };
  if (profile.start) {
    way.emplace_back(at(0).x(), at(0).y(), *profile.start);
    change_height(way, all[0].z, all.size() > 1 ? unit(at(0), at(1)) : Vector2::UnitX(),
                  circles(all[0].z, all[0]), terrain, vehicle);
  } else {
    way.emplace_back(at(0).x(), at(0).y(), all[0].z);
  }
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].corner) way.emplace_back(at(i).x(), at(i).y(), all[i].z);
  if (profile.end) {
    const std::size_t n = all.size();
    change_height(way, *profile.end, n > 1 ? unit(at(n - 2), at(n - 1)) : Vector2::UnitX(),
                  circles(*profile.end, all[n - 1]), terrain, vehicle);
    way.back().z() = *profile.end;
  }
  return way;
}

}  // namespace skein::refiners
