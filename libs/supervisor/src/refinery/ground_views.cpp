// SPDX-License-Identifier: Apache-2.0
// From where a vehicle that keeps to the ground sees a place: rings around it, looked at from the
// side of its home on; and in what order it drives to several.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "refinery/views.hpp"
#include "skein/refiners/driving.hpp"

namespace skein::supervisor {

using world::Vector3;

namespace {

constexpr double kAngleApart = std::numbers::pi / 3;  // [rad] between two views
constexpr double kSightAbove = 0.5;  // [m] over the ground: what lies there is seen
constexpr std::array<double, 5> kDistances = {0.4, 0.25, 0.6, 0.15, 0.8};  // of the sensor's range
constexpr int kSides = 24;
constexpr std::size_t kExactly =
    7;  // places in the best order of all; more from each to the nearest

double bearing(const Vector3& from, const Vector3& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

bool sees(const world::SensorModel& device, const Vector3& eye, const Vector3& target) {
  world::View view{eye, (target - eye).normalized(), device.range, device.aperture};
  if (!device.gimballed)
    view.direction = world::direction_of(bearing(eye, target), device.boresight_pitch);
  return world::in_view(view, target);
}

}  // namespace

Answer<std::vector<Vector3>> Views::from_the_ground(const Vector3& place,
                                                    const world::SensorModel& device,
                                                    const Stands& stands) const {
  const Vector3 target = gazetteer().above(place) + Vector3(0, 0, kSightAbove);
  std::vector<Vector3> found;
  const auto is_another_side = [&](double side) {
    return std::all_of(found.begin(), found.end(), [&](const Vector3& other) {
      return std::abs(world::wrapped(bearing(place, other) - side)) >= kAngleApart;
    });
  };
  const auto serves = [&](const Vector3& at) {
    const Vector3 eye = world::eye_of(vehicle(), at);
    return stands.map.is_free(air_.in_airspace(at)) && air_.has_room(at, stands.volumes) &&
           std::all_of(stands.constraints.begin(), stands.constraints.end(),
                       [&](const auto& one) { return one.holds(at); }) &&
           sees(device, eye, target) && world().terrain.line_of_sight(eye, target);
  };
  const double first = bearing(place, gazetteer().knowledge().home);
  for (int i = 0; i < kSides && found.size() < stands.count; ++i) {
    // 0, 1, -1, 2, …: the nearer to the side of home the sooner.
    const int turned = (i % 2 == 1 ? 1 : -1) * ((i + 1) / 2);
    const double side = first + turned * 2 * std::numbers::pi / kSides;
    if (!is_another_side(side)) continue;
    for (const double share : kDistances) {
      const double far = share * device.range;
      const Vector3 at =
          gazetteer().above(place + far * Vector3(std::cos(side), std::sin(side), 0));
      if (!serves(at)) continue;
      found.push_back(at);
      break;
    }
  }
  if (found.size() == stands.count) return found;
  return no("no ground around it that it can drive on has it in sight");
}

namespace {

/// Of ways between places: the first is where it begins.
using Lengths = std::vector<std::vector<double>>;

double length_of(const std::vector<std::size_t>& order, const Lengths& lengths) {
  double sum = 0;
  std::size_t at = 0;
  for (const std::size_t next : order) sum += lengths[std::exchange(at, next)][next];
  return sum;
}

std::vector<std::size_t> shortest_order(const Lengths& lengths) {
  std::vector<std::size_t> order(lengths.size() - 1);
  std::iota(order.begin(), order.end(), 1);
  if (order.size() <= kExactly) {
    std::vector<std::size_t> best = order;
    while (std::next_permutation(order.begin(), order.end()))
      if (length_of(order, lengths) < length_of(best, lengths)) best = order;
    return best;
  }
  std::size_t at = 0;
  for (auto next = order.begin(); next != order.end(); ++next) {
    const auto nearest = std::min_element(next, order.end(), [&](std::size_t a, std::size_t b) {
      return lengths[at][a] < lengths[at][b];
    });
    std::iter_swap(next, nearest);
    at = *next;
  }
  return order;
}

}  // namespace

Answer<std::vector<Vector3>> Views::tour_on_the_ground(const Vector3& from,
                                                       const std::vector<Stop>& stops,
                                                       const world::Airspace& map) const {
  std::vector<Vector3> points = {gazetteer().above(from)};
  for (const Stop& stop : stops) points.push_back(gazetteer().above(stop.at));
  const refiners::DrivingPlanner planner(map);
  Lengths lengths(points.size(), std::vector<double>(points.size(), 0));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 1; k < points.size(); ++k) {
      if (i == k) continue;
      const auto path = planner.plan(air_.query(points[i], points[k]), air_.setting());
      if (!path) return no(path.error().why);
      lengths[i][k] = path->task.length;
    }
  }
  std::vector<Vector3> order;
  for (const std::size_t i : shortest_order(lengths)) order.push_back(points[i]);
  return order;
}

}  // namespace skein::supervisor
