// SPDX-License-Identifier: Apache-2.0
#include "interaction/role_air.hpp"

#include "skein/world/crossing.hpp"

namespace skein::decision_node {

namespace {

using world::Vector3;

constexpr Duration kAhead = Duration::milliseconds(30'000);

std::vector<Vector3> points_of(const functional::Parameters& flight) {
  std::vector<Vector3> points;
  const functional::Parameter* flat = flight.find("waypoints");
  for (std::size_t i = 0; flat != nullptr && i + 2 < flat->numbers.size(); i += 3)
    points.emplace_back(flat->numbers[i], flat->numbers[i + 1], flat->numbers[i + 2]);
  return points;
}

}  // namespace

const world::Volume* closed_ahead(const functional::Parameters& flight,
                                  const world::VehicleState& state,
                                  const world::VehicleModel& model,
                                  const std::vector<world::Volume>& volumes, MissionTime now) {
  const std::vector<Vector3> points = points_of(flight);
  if (points.empty()) return nullptr;
  const Vector3& at = state.position;
  std::vector<Vector3> rest{at, points.front()};
  if (points.size() > 1) rest = world::rest_of(points, at);
  for (const world::Volume& volume : volumes) {
    const bool closes = volume.when.overlaps({now, now + kAhead});
    if (!closes || crosses(volume, model.body_radius, at, at)) continue;
    if (crosses(volume, model.body_radius, rest)) return &volume;
  }
  return nullptr;
}

}  // namespace skein::decision_node
