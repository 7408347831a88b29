// SPDX-License-Identifier: Apache-2.0
#include "path/space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/deadline.hpp"
#include "common/heights_over.hpp"
#include "common/shared_checks.hpp"
#include "path/checks.hpp"
#include "path/contact_space.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;
using world::Volume;

/// About what it takes to close a volume [ns]: a hundred of them are closed before a clock is
/// asked.
constexpr std::uint32_t kVolume = 1000;

/// On the level; 0 inside [m].
double distance(const world::Polygon& polygon, const Vector2& point) {
  if (world::contains(polygon, point)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& a = polygon[i];
    const Vector2 edge = polygon[(i + 1) % polygon.size()] - a;
    const double length2 = edge.squaredNorm();
    const double along = length2 > 0 ? std::clamp(edge.dot(point - a) / length2, 0.0, 1.0) : 0;
    least = std::min(least, (a + along * edge - point).norm());
  }
  return least;
}

/// Of a segment on the level; 0 where it is inside or crosses the border [m].
double distance(const world::Polygon& polygon, const Vector2& from, const Vector2& to) {
  double least = std::min(distance(polygon, from), distance(polygon, to));
  const auto side = [](const Vector2& a, const Vector2& b, const Vector2& point) {
    const Vector2 edge = b - a, offset = point - a;
    return edge.x() * offset.y() - edge.y() * offset.x();
  };
  for (std::size_t i = 0; least > 0 && i < polygon.size(); ++i) {
    const Vector2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((side(a, b, from) > 0) != (side(a, b, to) > 0) &&
        (side(from, to, a) > 0) != (side(from, to, b) > 0))
      return 0;
    least = std::min(least, distance({from, to}, a));
  }
  return least;
}

/// The box around all that is within the margin of the polygon, and a little more.
PathSpace::Outline outline_of(const world::Polygon& polygon, double margin) {
  constexpr double kRounding = 1e-6;
  PathSpace::Outline box;
  for (const Vector2& corner : polygon) box.extend(corner);
  const Vector2 reach = Vector2::Constant(margin + kRounding);
  return {box.min() - reach, box.max() + reach};
}

}  // namespace

PathSpace::PathSpace(const PathQuery& query, const world::World& world, Duration flight)
    : query_(query), world_(world) {
  const auto add = [&](const Volume& volume, const std::string& name) {
    counted_.push_back(can_be_met(volume, flight));
    if (!counted_.back()) return;
    volumes_.push_back(volume);
    outlines_.push_back(outline_of(volume.polygon, margin()));
    volume_names_.push_back(name);
  };
  for (const Volume& volume : world.volumes) add(volume, "volume '" + volume.name + "'");
  for (std::size_t i = 0; i < query.reserved.size(); ++i)
    add(query.reserved[i],
        "reserved." + std::to_string(i) +
            (query.reserved[i].name.empty() ? std::string()
                                            : " ('" + query.reserved[i].name + "')"));
  if (query.contact) anchors_ = anchors_of(*query.contact, world);
}

double PathSpace::margin() const {
  return query_.vehicle.body_radius + (query_.vehicle.hovers ? 0 : kChordTolerance);
}

bool PathSpace::can_be_met(const Volume& volume, Duration flight) const {
  const double fastest = query_.vehicle.max_speed +
                         query_.vehicle.wind_drift * (world_.wind.speed + world_.wind.gusts);
  const auto least_time = [&](const Vector3& end) {
    const double level = distance(volume.polygon, end.head<2>()) - margin();
    return Duration::seconds(std::max(0.0, level) / fastest);
  };
  const MissionTime first = query_.depart + least_time(query_.from);
  const MissionTime last = query_.depart + flight - least_time(query_.to);
  return volume.when.from <= last && first < volume.when.until;
}

std::optional<world::Airspace> PathSpace::airspace(const world::AirspaceGrid& grid,
                                                   const Budget& budget) const {
  world::AirspaceSpec spec;
  spec.grid = grid;
  spec.clearance = query_.clearance;
  spec.body_radius = margin();
  spec.ceiling = query_.vehicle.ceiling;
  auto airspace = world::Airspace::in_time(spec, world_.terrain, {}, budget.time_is_up);
  if (!airspace) return std::nullopt;
  Deadline deadline(budget);
  for (const Volume& volume : volumes_)
    if (deadline.passed_after(kVolume) || !airspace->block(volume, margin(), budget.time_is_up))
      return std::nullopt;
  const Vector3 low = world_.airspace.origin;
  const Vector3 high =
      low + world_.airspace.voxel *
                Vector3(world_.airspace.size[0], world_.airspace.size[1], world_.airspace.size[2]);
  const auto is_within = [&](const world::Voxel& voxel) {
    const Vector3 centre = airspace->centre(voxel), half = Vector3::Constant(grid.voxel / 2);
    return ((centre - half).array() >= low.array()).all() &&
           ((centre + half).array() <= high.array()).all();
  };
  if (grid != world_.airspace && !airspace->keep_where(is_within, budget.time_is_up))
    return std::nullopt;
  if (!anchors_.empty() && !keep_contact(*airspace, anchors_, world_, budget)) return std::nullopt;
  return airspace;
}

bool PathSpace::is_free(const Vector3& from, const Vector3& to) const {
  if (!anchors_.empty() || !within_limits(from) || !within_limits(to)) return false;
  if (world_.terrain.first_hit(from, to, std::max(query_.clearance, 3 * margin()))) return false;
  if (heights_over(world_.terrain, from, to).greatest > query_.vehicle.ceiling) return false;
  const Vector2 a = from.head<2>(), b = to.head<2>();
  const Outline around(a.cwiseMin(b), a.cwiseMax(b));
  for (std::size_t i = 0; i < volumes_.size(); ++i) {
    if (!outlines_[i].intersects(around)) continue;
    const Volume& volume = volumes_[i];
    if (std::max(from.z(), to.z()) >= volume.floor - margin() &&
        std::min(from.z(), to.z()) <= volume.ceiling + margin() &&
        distance(volume.polygon, a, b) <= margin())
      return false;
  }
  return true;
}

bool PathSpace::within_limits(const Vector3& at) const {
  const world::AirspaceGrid& grid = world_.airspace;
  const Vector3 high = grid.origin + grid.voxel * Vector3(grid.size[0], grid.size[1], grid.size[2]);
  return (at.array() >= grid.origin.array()).all() && (at.array() <= high.array()).all();
}

PathSpace PathSpace::without_contact() const {
  PathSpace other = *this;
  other.anchors_.clear();
  return other;
}

std::optional<std::string> PathSpace::blame(const Vector3& place) const {
  const double ground = world_.terrain.elevation(place.x(), place.y());
  const double height = place.z() - ground, least = std::max(query_.clearance, margin());
  if (height < 0) return "in the ground, which is " + rounded(ground) + " m high there";
  if (height < least)
    return rounded(height) + " m over the ground; at least " + rounded(least) + " m is asked for";
  for (std::size_t i = 0; i < volumes_.size(); ++i)
    if (place.z() >= volumes_[i].floor - margin() && place.z() <= volumes_[i].ceiling + margin() &&
        distance(volumes_[i].polygon, place.head<2>()) <= margin())
      return "in or within " + rounded(margin()) + " m of " + volume_names_[i];
  return std::nullopt;
}

Refusal PathSpace::closed(const Vector3& place, const std::string& field) const {
  if (!world::voxel_at(world_.airspace, place))
    return {RefusalKind::kBlocked, field, "the place is outside the airspace"};
  if (const auto why = blame(place)) return {RefusalKind::kBlocked, field, "the place is " + *why};
  const double height = place.z() - world_.terrain.elevation(place.x(), place.y());
  if (height > query_.vehicle.ceiling)
    return {RefusalKind::kBeyondVehicle, field,
            "the place is " + rounded(height) +
                " m over the ground, above the vehicle's ceiling of " +
                rounded(query_.vehicle.ceiling) + " m"};
  if (!anchors_.empty()) {
    const auto heard = [&](const Vector3& anchor) {
      return world_.radio.link(place, anchor, world_.terrain, false).up;
    };
    const bool some = std::any_of(anchors_.begin(), anchors_.end(), heard);
    return {RefusalKind::kNoContact, field,
            some ? "there is radio contact at the place, but not all around it"
                 : "there is no radio contact at the place"};
  }
  return {
      RefusalKind::kBlocked, field,
      "the ground, a volume or the vehicle's ceiling is too near the place for a voxel between"};
}

Result<world::Airspace, Refusal> airspace_of(const PathQuery& query, const Setting& setting,
                                             Duration flight) {
  if (auto problem = check(query, setting.world)) return tl::unexpected(*problem);
  auto airspace =
      PathSpace(query, setting.world, flight).airspace(setting.world.airspace, setting.budget);
  if (!airspace)
    return refuse(RefusalKind::kBudgetExhausted, "",
                  "the time was up before it was known which air is open");
  return std::move(*airspace);
}

}  // namespace skein::refiners
