// SPDX-License-Identifier: Apache-2.0
#include "site.hpp"

#include <algorithm>
#include <utility>

namespace skein::import_tool {

using mission_files::Height;
using mission_files::HeightOver;
using mission_files::LatLon;
using world::Vector2;
using world::Vector3;

Site::Site(const world::GeodeticOrigin& origin, world::TerrainSpec terrain, const LatLon& home,
           std::optional<double> home_over_sea, std::optional<double> geoid)
    : frame_(origin), terrain_(std::move(terrain)), home_(Vector3::Zero()), sea_(geoid) {
  const Vector2 there = on_ground(home);
  home_ = {there.x(), there.y(), terrain_.elevation(there.x(), there.y())};
  home_over_ellipsoid_ = frame_.to_geodetic(home_).altitude;
  if (!sea_ && home_over_sea) sea_ = home_over_ellipsoid_ - *home_over_sea;
}

Vector2 Site::on_ground(const LatLon& at) const {
  return frame_.to_local({at.latitude, at.longitude, frame_.origin().altitude}).head<2>();
}

std::optional<Vector3> Site::at(const LatLon& at, const Height& height) const {
  if (height.over == HeightOver::kGround) {
    const Vector2 there = on_ground(at);
    return Vector3(there.x(), there.y(), terrain_.elevation(there.x(), there.y()) + height.metres);
  }
  if (height.over == HeightOver::kSeaLevel && !sea_) return std::nullopt;
  const double from = height.over == HeightOver::kHome ? home_over_ellipsoid_ : *sea_;
  return frame_.to_local({at.latitude, at.longitude, from + height.metres});
}

std::optional<double> Site::height_at(const Vector3& point, const Height& height) const {
  if (height.over == HeightOver::kGround) return ground_at(point) + height.metres;
  if (height.over == HeightOver::kHome) return home_.z() + height.metres;
  if (!sea_) return std::nullopt;
  return home_.z() + *sea_ + height.metres - home_over_ellipsoid_;
}

void Sides::include(const Vector2& point) {
  west = std::min(west, point.x());
  south = std::min(south, point.y());
  east = std::max(east, point.x());
  north = std::max(north, point.y());
}

Sides sides_of(const world::Polygon& polygon) {
  const Vector2& first = polygon.front();
  Sides sides{first.x(), first.y(), first.x(), first.y()};
  for (const Vector2& corner : polygon) sides.include(corner);
  return sides;
}

}  // namespace skein::import_tool
