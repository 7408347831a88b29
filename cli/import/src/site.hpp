// SPDX-License-Identifier: Apache-2.0
// Frame, ground and home position of an imported mission.
#pragma once

#include <optional>

#include "log.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/mission_files/contents.hpp"
#include "skein/world/terrain.hpp"

namespace skein::import_tool {

/// Least height of a way-point over the ground, as vehicles have it [m].
inline constexpr double kLeastHeight = 2;

/// Heights of files, which count from home, the ground or sea level, in the local frame.
class Site {
 public:
  /// `home_over_sea`: of the file; `geoid`: of sea level over the ellipsoid, which counts before
  /// it. [m]
  Site(const world::GeodeticOrigin& origin, world::TerrainSpec terrain,
       const mission_files::LatLon& home, std::optional<double> home_over_sea,
       std::optional<double> geoid);

  const world::Terrain& terrain() const { return terrain_; }
  /// The home position, on the ground.
  const world::Vector3& home() const { return home_; }
  world::Vector2 on_ground(const mission_files::LatLon& at) const;
  double ground_at(const world::Vector3& point) const {
    return terrain_.elevation(point.x(), point.y());
  }
  /// The position in the local frame; nothing for a height over sea level if the geoid is unknown.
  std::optional<world::Vector3> at(const mission_files::LatLon& at,
                                   const mission_files::Height& height) const;
  /// The z of a height over (or under) a point [m]; nothing likewise.
  std::optional<double> height_at(const world::Vector3& point,
                                  const mission_files::Height& height) const;

 private:
  geodesy::GeodeticFrame frame_;
  world::Terrain terrain_;
  world::Vector3 home_;
  double home_over_ellipsoid_ = 0;
  /// Height of sea level over the ellipsoid [m], if known.
  std::optional<double> sea_;
};

/// A rectangle of the local frame [m].
struct Sides {
  double west = 0, south = 0, east = 0, north = 0;
  void include(const world::Vector2& point);
};
/// Around a polygon. Precondition: it has a corner.
Sides sides_of(const world::Polygon& polygon);

}  // namespace skein::import_tool
