// SPDX-License-Identifier: Apache-2.0
// `skein import`: another program's mission as a scenario.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/mission_files/contents.hpp"

namespace skein::import_tool {

struct ImportOptions {
  std::string file;          ///< .plan, way-points or KML
  std::string world;         ///< world file of the scenario; empty: level ground around the mission
  std::string uav = "uav";   ///< who flies it
  std::string model;         ///< its vehicle model
  std::string out;           ///< the scenario file; empty: standard output
  std::string name;          ///< of the scenario; empty: of the file
  std::vector<double> home;  ///< latitude, longitude [degrees]; empty: as the file says it
  double altitude = 40;      ///< of ways of which the file says no height, over the ground [m]
  std::optional<double> geoid;      ///< of sea level there over the ellipsoid [m]
  std::vector<std::string> closed;  ///< names of areas, or of their folders, that are closed air
  std::string camera;               ///< device that takes the pictures
  bool leave_out = false;           ///< what has no counterpart, instead of refusing the file
};

/// The result of an import.
struct Imported {
  std::string yaml;               ///< the scenario; `skein run` takes it
  std::vector<std::string> said;  ///< what was taken for granted, for people
  Diagnostics left_out;           ///< of the file: told in comments of the scenario too
};

/// The scenario of a mission, as one that stands at `scenario_file`; every error at once. Reads the
/// world, the vehicle model and what they name.
Result<Imported, Diagnostics> to_scenario(const mission_files::Contents& contents,
                                          const ImportOptions& options,
                                          const std::string& scenario_file);

/// Exit codes: cli/import/README.md.
int import_mission(const ImportOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::import_tool
