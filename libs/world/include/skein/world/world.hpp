// SPDX-License-Identifier: Apache-2.0
// The world model of the refiners.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "skein/world/airspace.hpp"
#include "skein/world/geodetic.hpp"
#include "skein/world/ground_state.hpp"
#include "skein/world/radio_model.hpp"
#include "skein/world/terrain.hpp"
#include "skein/world/volume.hpp"
#include "skein/world/wind.hpp"
#include "skein/world/zone.hpp"

namespace skein::world {

/// A value type; reading is const and safe from any thread.
struct World {
  GeodeticOrigin origin;
  Terrain terrain;
  Wind wind;
  AirspaceGrid airspace;        ///< the voxels of the way-point graph
  std::vector<Volume> volumes;  ///< no-fly volumes, with time windows
  GroundState ground;
  RadioModel radio;
  std::vector<Zone> zones;                             ///< named areas
  std::map<std::string, Vector3, std::less<>> places;  ///< named points [m], ENU
};

}  // namespace skein::world
