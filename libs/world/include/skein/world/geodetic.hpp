// SPDX-License-Identifier: Apache-2.0
// Where on Earth a scenario's local frame stands.
#pragma once

namespace skein::world {

/// The origin of the local ENU frame (WGS 84). In degrees, as every map and geodesy library has it.
struct GeodeticOrigin {
  double latitude_degrees = 0;   ///< [-90, 90], north positive
  double longitude_degrees = 0;  ///< [-180, 180], east positive
  double altitude = 0;           ///< above the ellipsoid [m]
  bool operator==(const GeodeticOrigin&) const = default;
};

}  // namespace skein::world
