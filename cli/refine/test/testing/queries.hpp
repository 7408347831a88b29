// SPDX-License-Identifier: Apache-2.0
// Queries in the tests of the refine tool: small worlds, read without files.
#pragma once

#include <string>

#include "query_reader.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/world/world_builder.hpp"

namespace skein::refine_tool::testing {

inline tl::unexpected<Diagnostics> missing(const std::string& file) {
  Diagnostics diagnostics;
  Diagnostic one;
  one.file = file;
  one.message = "there is no such file";
  diagnostics.add(one);
  return tl::make_unexpected(diagnostics);
}

/// Worlds and models inside the query only: every file is missing.
inline References no_files() {
  return {
      [](const std::string& file) -> Result<world::World, Diagnostics> { return missing(file); },
      [](world::WorldFile file) { return world::build_world(std::move(file)); },
      [](const std::string& file) -> Result<world::VehicleModel, Diagnostics> {
        return missing(file);
      }};
}

inline const std::string kWorld = R"("world": {
  "origin": {"latitude": 40, "longitude": -8, "altitude": 0},
  "terrain": {"west": -500, "south": -500, "east": 500, "north": 500, "cell": 50,
              "hills": [{"at": [0, 0], "height": 40, "radius": 200}]},
  "airspace": {"floor": 0, "ceiling": 200, "voxel": 20},
  "zones": {"field": [[-300, -300], [300, -300], [300, 300], [-300, 300]]},
  "places": {"pad": [-400, -400, 30], "far": [400, 400, 60]}
})";

inline const std::string kVehicle = R"("vehicle": {
  "model": "h", "kind": "helicopter", "hovers": true, "speed": {"cruise": 10, "max": 15},
  "climb_rate": 4, "descent_rate": 3, "acceleration": 2, "yaw_rate": 1, "ceiling": 400,
  "position_precision": 1, "wind_drift": 0.2,
  "energy": {"capacity": 5e6, "hover": 1000, "cruise": 1200, "reserve": 0.1},
  "sensors": {
    "down": {"aperture": 0.4636476, "pitch": -1.5708, "range": 150, "period": 1,
             "position_spread": 1, "sees": {"fire": {"probability": 1, "confidence": 1}}},
    "ahead": {"aperture": 0.4, "pitch": 0, "range": 150, "period": 1, "position_spread": 1,
              "sees": {"fire": {"probability": 1, "confidence": 1}}}
  }
})";

/// {service, world, vehicle, …}.
inline std::string query_text(const std::string& service, const std::string& rest) {
  return "{\"service\": \"" + service + "\",\n" + kWorld + ",\n" + kVehicle +
         (rest.empty() ? "" : ",\n" + rest) + "}";
}

inline Result<Query, Diagnostics> read(const std::string& service, const std::string& rest) {
  return read_query(query_text(service, rest), "q.json", no_files());
}

/// The question of a query that reads well.
template <class T>
T question_of(const std::string& service, const std::string& rest) {
  auto query = read(service, rest);
  if (!query) throw std::runtime_error(to_text(query.error()));
  return std::get<T>(query->question);
}

/// All errors as text, empty when there are none.
inline std::string errors_of(const std::string& service, const std::string& rest) {
  const auto query = read(service, rest);
  return query ? "" : to_text(query.error());
}

}  // namespace skein::refine_tool::testing
