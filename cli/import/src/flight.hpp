// SPDX-License-Identifier: Apache-2.0
// A mission's steps as elementary tasks of one UAV.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "log.hpp"
#include "site.hpp"
#include "skein/mission_files/contents.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/volume.hpp"

namespace skein::import_tool {

struct FlightTask {
  int id = 0;  ///< from 1
  std::string type;
  std::string params;    ///< in YAML: "{altitude: 30}"; empty: none
  int after = 0;         ///< of the task that has to end first; 0: none
  int until_end_of = 0;  ///< it runs until that one ends; 0: by itself
};

struct Flight {
  std::vector<FlightTask> tasks;  ///< each behind those that it waits for
  int last = 0;                   ///< of those that fly; 0: none
  bool lands = false;             ///< it is on the ground at the end
  double seconds = 0;             ///< as it is estimated
};

struct FlightOptions {
  std::string camera;    ///< device of pictures; empty: none is said
  double altitude = 40;  ///< where the file says no height, over the ground [m]
};

/// Way-points between which nothing else happens make one way. What flies before it has taken off
/// takes off first. Refused, in the log: ways below or above what the vehicle flies, in closed air,
/// faster than it is.
Flight flight_of(const std::vector<mission_files::Item>& items, const FlightOptions& options,
                 const Site& site, const world::VehicleModel& model,
                 const std::vector<world::Volume>& closed, Log& log);

/// A figure for a file: to the centimetre.
std::string figure(double value);

}  // namespace skein::import_tool
