// SPDX-License-Identifier: Apache-2.0
#include "refinery/views.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "skein/refiners/tour.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::supervisor {

using world::Vector3;

namespace {

constexpr double kAngleApart = std::numbers::pi / 3;  // [rad] between two views
constexpr double kCostOfWay = 1e-4;                   // of utility, per metre
constexpr double kNearShare = 0.5;                    // of its range, for a sensor to see well
constexpr double kSteep = 1.25;  // distances over heights that it must reach at least

}  // namespace

Answer<std::vector<Vector3>> Views::of(const Vector3& place, const world::SensorModel& device,
                                       std::size_t count, const Departure& when, double seconds,
                                       const Constraints& constraints) {
  world::World then = world();
  const double there =
      flight_times({gazetteer().above(gazetteer().knowledge().home), gazetteer().above(place)},
                   vehicle(), world().wind)
          .most;
  const TimedAir::Counted counts = air_.counted(when, there + seconds);
  then.volumes = air_.closed(counts);
  for (world::Volume& volume : then.volumes) volume.when = {};
  const auto air = air_.airspace(counts);
  if (!air) return no(air.error());
  if (vehicle().ground)
    return from_the_ground(place, device, {count, **air, then.volumes, constraints});
  refiners::ViewpointQuery query;
  query.constraints = constraints;
  query.constraints.push_back({"free air", [this, free = *air, &then](const Vector3& at) {
                                 return free->is_free(at) &&
                                        (vehicle().hovers || air_.has_room(at, then.volumes));
                               }});
  query.vehicle = air_.cautious();
  query.device = device.device;
  query.target = place;
  // On the side of home, and near enough to see well; the same places from wherever it asks, so
  // that who is there stays.
  query.from = gazetteer().above(gazetteer().knowledge().home);
  query.cost_of_way = kCostOfWay;
  // From the usual altitude; lower only where the sensor does not reach from there.
  query.clearance = std::min(gazetteer().knowledge().altitude, vehicle().ceiling / 2);
  query.farthest =
      std::min(device.range, std::max(device.range * kNearShare, kSteep * query.clearance));
  query.count = count;
  query.least_angle = count > 1 ? kAngleApart : 0;
  query.at = air_.origin();
  const refiners::Setting at_that_time = air_.setting(then);
  auto refined = refine(query, at_that_time);
  if (!refined || refined->task.points.size() < count) {
    query.clearance = air_.clearance() + vehicle().body_radius;
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

// Air that is closed for a time is for the ways between the places.
Answer<std::vector<Vector3>> Views::tour(const Vector3& from, const std::vector<Stop>& stops) {
  const TimedAir::Counted counts = air_.counted({.suited = true}, 0);
  const auto air = air_.airspace(counts);
  if (!air) return no(air.error());
  if (vehicle().ground) return tour_on_the_ground(from, stops, **air);
  world::World then = world();
  then.volumes = air_.closed(counts);
  refiners::TourQuery query;
  query.vehicle = air_.cautious();
  query.start = gazetteer().flown_to(from);
  for (const Stop& stop : stops) {
    const Vector3 at = gazetteer().flown_to(stop.at);
    query.stops.push_back({stop.name, {{at, at, Duration()}}});
  }
  query.clearance = air_.clearance();
  query.depart = air_.origin();
  const refiners::VoxelPathPlanner planner(**air);
  const auto refined = refine(query, air_.setting(then, &planner));
  if (!refined) return no(refined.error().why);
  std::vector<Vector3> order;
  for (const refiners::Visit& visit : refined->task.visits)
    order.push_back(query.stops[visit.stop].gates.front().entry);
  return order;
}

}  // namespace skein::supervisor
