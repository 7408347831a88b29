// SPDX-License-Identifier: Apache-2.0
// The program skein-air.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "skein/air/weather.hpp"
#include "skein/blackboard/network.hpp"

namespace skein::air {

struct AirOptions {
  std::string scenario;
  bool list = false;                ///< print the nodes of the air, one a line, and end
  std::vector<std::string> faults;  ///< fault scripts
  std::string write;                ///< file for the scenario with these, and end; empty: none
  std::string spaces = "/run/netns";
  std::string interface = "radio";  ///< name of the TUN devices
  std::uint32_t domain = 0;
  blackboard::NetworkConfig network;  ///< where the simulator is
  Everywhere everywhere;
  std::uint64_t seed = 1;
  double longest_queue = 2;  ///< [s]
  std::string report;        ///< file for the counts at the end, as JSON; empty: none
};

/// Carries packets until it is told to stop. Says "ready" on `out` once its devices are there. Exit
/// codes: 0; 2 wrong input; 3 the system refuses a device, or DDS to take part.
int run_air(const AirOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::air
