// SPDX-License-Identifier: Apache-2.0
// Between places on Earth and the local ENU frame.
#pragma once

#include <memory>

#include "skein/world/geodetic.hpp"
#include "skein/world/geometry.hpp"

namespace GeographicLib {
class LocalCartesian;
}

namespace skein::geodesy {

/// Straight axes at an origin on WGS 84: x east, y north, z up [m]. The frame does not bend with
/// the Earth: 10 km away, what has the altitude of the origin is 8 m below z = 0. A few nanometres
/// of rounding within 100 km. A value type; reading is const and safe from any thread. Source:
/// spec 1.4, 4.1.
class GeodeticFrame {
 public:
  /// Precondition: figures in the ranges of GeodeticPoint, finite.
  explicit GeodeticFrame(const world::GeodeticOrigin& origin);

  world::Vector3 to_local(const world::GeodeticPoint& point) const;
  /// Longitude in [-180, 180].
  world::GeodeticPoint to_geodetic(const world::Vector3& local) const;
  const world::GeodeticOrigin& origin() const { return origin_; }

 private:
  world::GeodeticOrigin origin_;
  std::shared_ptr<const GeographicLib::LocalCartesian> frame_;
};

}  // namespace skein::geodesy
