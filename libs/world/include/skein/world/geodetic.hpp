// SPDX-License-Identifier: Apache-2.0
// Places on Earth, and where on it a scenario's local frame stands.
#pragma once

namespace skein::world {

/// WGS 84. In degrees, as every map and geodesy library has it.
struct GeodeticPoint {
  double latitude_degrees = 0;   ///< [-90, 90], north positive
  double longitude_degrees = 0;  ///< [-180, 180], east positive
  double altitude = 0;           ///< above the ellipsoid [m]
  bool operator==(const GeodeticPoint&) const = default;
};

/// The origin of the local ENU frame.
using GeodeticOrigin = GeodeticPoint;

}  // namespace skein::world
