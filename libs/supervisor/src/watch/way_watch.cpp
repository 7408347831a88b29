// SPDX-License-Identifier: Apache-2.0
#include "watch/way_watch.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "book/progress.hpp"
#include "flight/flight_times.hpp"
#include "skein/world/segment.hpp"

namespace skein::supervisor {

namespace {

using world::Vector2;
using world::Vector3;

constexpr double kReachedMargin = 2;  // [m] beyond what it arrives within, between two states
// Between two states further apart nobody knows where the vehicle was.
constexpr Duration kSeenOften = Duration::milliseconds(3'000);
constexpr double kPointsAcross = 8;  // of a zone

/// The zone of a detection; null if there is none of that name.
const world::Zone* zone_of(const mission::HighLevelTask& task, const world::World& world) {
  if (task.name != kDetection || task.arguments.empty()) return nullptr;
  const auto* name = std::get_if<std::string>(&task.arguments.front());
  if (name == nullptr) return nullptr;
  const auto found = std::find_if(world.zones.begin(), world.zones.end(),
                                  [&](const world::Zone& zone) { return zone.name == *name; });
  return found == world.zones.end() ? nullptr : &*found;
}

/// The point of a zone that is nearest to another one.
Vector2 nearest_of(const world::Polygon& zone, const Vector2& to) {
  if (world::contains(zone, to)) return to;
  Vector2 nearest = zone.front();
  for (std::size_t i = 0; i < zone.size(); ++i) {
    const Vector2 point = world::nearest_on_segment(to, zone[i], zone[(i + 1) % zone.size()]);
    if ((point - to).norm() < (nearest - to).norm()) nearest = point;
  }
  return nearest;
}

/// Of a zone: its corners, a lattice.
std::vector<Vector2> points_of(const world::Polygon& zone) {
  std::vector<Vector2> points(zone.begin(), zone.end());
  Vector2 low = zone.front(), high = zone.front();
  for (const Vector2& corner : zone) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const Vector2 step = (high - low) / kPointsAcross;
  for (double i = 0.5; i < kPointsAcross; ++i)
    for (double j = 0.5; j < kPointsAcross; ++j) {
      const Vector2 point = low + Vector2(i * step.x(), j * step.y());
      if (world::contains(zone, point)) points.push_back(point);
    }
  return points;
}

/// Where the axis of a view meets level ground, no further away than its range.
Vector2 foot_of(const world::View& view, double ground) {
  const double height = view.viewpoint.z() - ground, down = -view.direction.z();
  const double far = std::min(view.range, down > 0 ? height / down : view.range);
  return (view.viewpoint + far * view.direction).head<2>();
}

/// Some ground of the zone is in view.
bool sees(const world::View& view, const world::Polygon& zone, const world::Terrain& terrain) {
  const auto in_view = [&](const Vector2& at) {
    return world::in_view(view, Vector3(at.x(), at.y(), terrain.elevation(at.x(), at.y())));
  };
  const Vector2 below = view.viewpoint.head<2>();
  if (in_view(nearest_of(zone, foot_of(view, terrain.elevation(below.x(), below.y())))))
    return true;
  if (in_view(nearest_of(zone, below))) return true;
  const std::vector<Vector2> points = points_of(zone);
  return std::any_of(points.begin(), points.end(), in_view);
}

/// What the device of a look sees from there, fixed to the vehicle or aimed.
world::View view_of(const mission::ElementaryTask& look, const world::SensorModel& device,
                    const world::VehicleModel& model, const world::VehicleState& state) {
  const Vector3 eye = world::eye_of(model, state.position);
  Vector3 axis = world::direction_of(state.heading, device.boresight_pitch);
  const executive::Parameter* target = look.parameters.find("target");
  if (device.gimballed && target != nullptr && target->numbers.size() == 3) {
    const auto& at = target->numbers;
    axis = (Vector3(at[0], at[1], at[2]) - eye).normalized();
  }
  return {eye, axis, device.range, device.aperture};
}

}  // namespace

void WayWatch::watch(Entry& look, const world::VehicleState& state, MissionTime now) const {
  if (!seen_ || now - *seen_ > kSeenOften) return;
  const auto goal = book_.goals.find(look.task.origin);
  const executive::Parameter* device = look.task.parameters.find("device");
  if (goal == book_.goals.end() || device == nullptr) return;
  const world::Zone* zone = zone_of(goal->second.task, beliefs_.world());
  const world::SensorModel* sensor = world::find_sensor(beliefs_.model(), device->text);
  if (zone == nullptr || sensor == nullptr) return;
  const Duration since = now - std::max(*seen_, *look.running);
  look.watched = look.watched + since;
  const world::View view = view_of(look.task, *sensor, beliefs_.model(), state);
  if (sees(view, zone->polygon, beliefs_.world().terrain)) look.viewed = look.viewed + since;
}

void WayWatch::see(const world::VehicleState& state, MissionTime now) {
  const double reach =
      arrival_distance(beliefs_.knowledge().vehicle, beliefs_.world().wind) + kReachedMargin;
  for (auto& [id, entry] : book_.tasks) {
    if (!entry.given() || entry.over() || !entry.running) continue;
    const Entry* along = flown_along(book_, entry);
    if (along == nullptr || along->over() || !along->running) continue;
    entry.passed = passed_after(along->task.way, entry.passed, beliefs_.vehicle().position,
                                state.position, reach);
    watch(entry, state, now);
  }
  seen_ = now;
}

}  // namespace skein::supervisor
