// SPDX-License-Identifier: Apache-2.0
#include "viewpoint/field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "skein/foundation/contract.hpp"
#include "skein/world/ground_normal.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;

/// What is to be seen stands at least so high over the ground, else rounding would bury it [m].
constexpr double kShows = 0.01;
/// Sight that passes nearer over the ground than that is none: either answer would be rounding [m].
constexpr double kGrazing = 1e-6;
/// Bounds are kept by so much, relatively, that rounding does not break them.
constexpr double kInside = 1e-9;
constexpr double kRightAngle = std::numbers::pi / 2;
/// Straight above the target there is no azimuth: places are at least so far aside [rad].
constexpr double kAside = 1e-4;

BearingCell whole_of(const ViewpointQuery& query, const world::SensorModel& sensor) {
  BearingCell whole;
  whole.azimuth_end = Bearing::kTurn;
  const double most = query.farthest > 0 ? std::min(query.farthest, sensor.range) : sensor.range;
  whole.range_end = most * (1 - kInside);
  whole.range = std::min(std::max(query.nearest * (1 + kInside), most * 1e-3), whole.range_end);
  // Where the target is up by some pitch, the place is down by as much from the target.
  const double reach = sensor.gimballed ? 2 * kRightAngle : sensor.aperture * (1 - kInside);
  const double pitch = std::clamp(sensor.boresight_pitch, -kRightAngle, kRightAngle);
  constexpr double steepest = kRightAngle - kAside;
  whole.elevation = std::clamp(-pitch - reach, -steepest, steepest);
  whole.elevation_end = std::clamp(-pitch + reach, -steepest, steepest);
  return whole;
}

}  // namespace

double Bearing::radians(std::int32_t azimuth) { return 2 * std::numbers::pi * azimuth / kTurn; }

Bearing BearingCell::middle() const {
  return {(azimuth + azimuth_end) / 2, (elevation + elevation_end) / 2, (range + range_end) / 2};
}

double BearingCell::angular_radius() const {
  const double lowest = elevation <= 0 && elevation_end >= 0
                            ? 0
                            : std::min(std::abs(elevation), std::abs(elevation_end));
  const double turn = Bearing::radians(azimuth_end - azimuth + 1) / 2;
  return std::hypot((elevation_end - elevation) / 2, turn * std::cos(lowest));
}

ViewpointField::ViewpointField(const ViewpointQuery& query, const Setting& setting,
                               const world::SensorModel& sensor)
    : query_(query),
      world_(setting.world),
      sensor_(sensor),
      eye_(query.target),
      normal_(world::ground_normal(setting.world.terrain, query.target.x(), query.target.y())),
      whole_(whole_of(query, sensor)) {
  const double ground = world_.terrain.elevation(eye_.x(), eye_.y());
  eye_.z() = std::max(eye_.z(), ground + kShows);
  const world::TimeWindow from_then_on{query.at, MissionTime::max()};
  for (const world::Volume& volume : world_.volumes)
    if (volume.when.overlaps(from_then_on)) volumes_.push_back(&volume);
}

Vector3 ViewpointField::position(const Bearing& bearing) const {
  return query_.target +
         bearing.range * world::direction_of(Bearing::radians(bearing.azimuth), bearing.elevation);
}

Place ViewpointField::place(const Bearing& bearing) const {
  Place place;
  place.position = position(bearing);
  place.quality = world::perceived_quality(sensor_, place.position, query_.target, normal_);
  const double way = query_.from ? (place.position - *query_.from).norm() : 0;
  place.utility = place.quality - sensor_.cost - query_.cost_of_way * way;
  return place;
}

Aspect ViewpointField::aspect_of(const BearingCell& cell) const {
  const Bearing middle = cell.middle();
  Aspect aspect;
  aspect.direction = world::direction_of(Bearing::radians(middle.azimuth), middle.elevation);
  aspect.radius = cell.angular_radius();
  const double incidence = std::acos(std::clamp(aspect.direction.dot(normal_), -1.0, 1.0));
  aspect.quality =
      world::incidence_quality(sensor_, std::cos(std::max(0.0, incidence - aspect.radius)));
  return aspect;
}

double ViewpointField::utility_bound(const BearingCell& cell, const Aspect& aspect) const {
  const double best = world::distance_quality(sensor_, cell.range) * aspect.quality;
  double way = 0;
  if (query_.from && query_.cost_of_way > 0) {
    const double extent =
        std::hypot((cell.range_end - cell.range) / 2, cell.range_end * aspect.radius);
    const Vector3 middle = query_.target + cell.middle().range * aspect.direction;
    way = std::max(0.0, (middle - *query_.from).norm() - extent);
  }
  return best - sensor_.cost - query_.cost_of_way * way;
}

bool ViewpointField::is_outside(const Vector3& position) const {
  const world::AirspaceGrid& air = world_.airspace;
  const Vector3 size(air.size[0], air.size[1], air.size[2]);
  const Vector3 offset = (position - air.origin) / air.voxel;
  return !((offset.array() >= 0).all() && (offset.array() <= size.array()).all());
}

Verdict ViewpointField::judge_position(const Vector3& position) const {
  if (is_outside(position)) return {Fate::kOutside};
  const double height = position.z() - world_.terrain.elevation(position.x(), position.y());
  if (height < query_.clearance) return {Fate::kTooLow};
  if (height > query_.vehicle.ceiling) return {Fate::kTooHigh};
  for (std::size_t i = 0; i < volumes_.size(); ++i) {
    const world::Volume& volume = *volumes_[i];
    if (position.z() >= volume.floor && position.z() <= volume.ceiling &&
        world::contains(volume.polygon, Vector2(position.head<2>())))
      return {Fate::kInVolume, i};
  }
  for (std::size_t i = 0; i < query_.constraints.size(); ++i)
    if (!query_.constraints[i].holds(position)) return {Fate::kConstraint, i};
  return {};
}

bool ViewpointField::sees(const Bearing& bearing, const Vector3& position) {
  auto known = horizons_.find(bearing.azimuth);
  if (known == horizons_.end()) {
    ++sight_checks_;
    known = horizons_
                .try_emplace(bearing.azimuth, world_.terrain, eye_,
                             Bearing::radians(bearing.azimuth), whole_.range_end)
                .first;
  }
  return known->second.sees(bearing.range * std::cos(bearing.elevation), position.z() - kGrazing);
}

Verdict ViewpointField::judge(const Bearing& bearing, const Place& place) {
  if (!(place.quality > 0)) return {Fate::kImperceptible};
  if (const Verdict verdict = judge_position(place.position); verdict.fate != Fate::kGood)
    return verdict;
  return {sees(bearing, place.position) ? Fate::kGood : Fate::kHidden};
}

ViewPoint ViewpointField::view_point(const Bearing& bearing) const {
  const Place here = place(bearing);
  ViewPoint point;
  point.position = here.position;
  const Vector3 offset = query_.target - point.position;
  point.heading = std::atan2(offset.y(), offset.x());
  point.pitch = sensor_.gimballed ? std::asin(std::clamp(offset.z() / offset.norm(), -1.0, 1.0))
                                  : sensor_.boresight_pitch;
  point.quality = here.quality;
  point.utility = here.utility;
  return point;
}

std::string ViewpointField::describe(const Verdict& verdict) const {
  switch (verdict.fate) {
    case Fate::kGood:
      return "good";
    case Fate::kImperceptible:
      return "where its quality is nil";
    case Fate::kOutside:
      return "outside the airspace";
    case Fate::kTooLow:
      return "under the clearance";
    case Fate::kTooHigh:
      return "over the vehicle's ceiling";
    case Fate::kInVolume:
      return "in volume '" + volumes_[verdict.which]->name + "'";
    case Fate::kConstraint:
      return "against constraint '" + query_.constraints[verdict.which].name + "'";
    case Fate::kTaken:
      return "too near another";
    case Fate::kHidden:
      return "hidden by the ground";
  }
  SKEIN_ENSURES(false);
}

}  // namespace skein::refiners
