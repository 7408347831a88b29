// SPDX-License-Identifier: Apache-2.0
#include "interaction/role_air.hpp"

#include "skein/elementary/parameter_reader.hpp"
#include "skein/world/crossing.hpp"

namespace skein::decision_node {

namespace {

using world::Vector3;

constexpr Duration kAhead = Duration::milliseconds(30'000);
constexpr double kBrakes = 5;  // within so many seconds

/// What of a way comes before so much of its length [m].
std::vector<Vector3> first_of(const std::vector<Vector3>& way, double length) {
  std::vector<Vector3> first;
  for (const Vector3& next : way) {
    const double leg = first.empty() ? 0 : (next - first.back()).norm();
    if (leg > length) {
      first.push_back(first.back() + length / leg * (next - first.back()));
      break;
    }
    length -= leg;
    first.push_back(next);
  }
  return first;
}

}  // namespace

const world::Volume* closed_ahead(const functional::Parameters& flight, const Vector3& from,
                                  const world::VehicleState& state,
                                  const world::VehicleModel& model,
                                  const std::vector<world::Volume>& volumes, MissionTime now) {
  std::vector<Vector3> way = elementary::ParameterReader(flight).points("waypoints");
  if (way.empty()) return nullptr;
  way.insert(way.begin(), from);
  const Vector3& at = state.position;
  const std::vector<Vector3> rest = world::rest_of(way, at);
  for (const world::Volume& volume : volumes) {
    const bool closes = volume.when.overlaps({now, now + kAhead});
    if (!closes || crosses(volume, model.body_radius, at, at)) continue;
    const double open_in = (volume.when.until - now).to_seconds();
    if (crosses(volume, model.body_radius,
                first_of(rest, model.cruise_speed * (open_in + kBrakes))))
      return &volume;
  }
  return nullptr;
}

}  // namespace skein::decision_node
