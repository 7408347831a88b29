// SPDX-License-Identifier: Apache-2.0
// What was imported, as a scenario file that people read on.
#pragma once

#include <map>
#include <string>

#include "airspace.hpp"
#include "flight.hpp"
#include "skein/import_tool/import.hpp"
#include "skein/world/geodetic.hpp"

namespace skein::import_tool {

/// The ground: a world file's, or level and as large as this.
struct Ground {
  std::string world;  ///< world file as the scenario names it; empty: the level ground
  world::GeodeticOrigin origin;
  Sides sides;
  double cell = 20;
};

struct Parts {
  std::string name;
  std::string source;  ///< the file's name, for people
  Ground ground;
  std::string uav, model;  ///< the model as the scenario names it
  world::Vector3 start = world::Vector3::Zero();
  Airspace airspace;
  std::map<std::string, world::Vector3> places;
  Flight flight;
};

std::string scenario_text(const Parts& parts, const Diagnostics& left_out);

/// The `world` and `uavs` of a scenario in which nothing happens.
std::string empty_scenario_text(const Ground& ground, const std::string& uav,
                                const std::string& model);

}  // namespace skein::import_tool
