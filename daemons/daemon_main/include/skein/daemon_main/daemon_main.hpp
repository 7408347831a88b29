// SPDX-License-Identifier: Apache-2.0
// What the three daemons' mains share: options, scenario, logging, running.
#pragma once

#include <string>

namespace skein::daemon_main {

struct DaemonProgram {
  std::string name;         ///< "skein-ddn"
  std::string description;  ///< one line for --help
  std::string node;         ///< the node it runs: "ground", "sim"; empty: the UAV given by --uav
  bool plays_vehicles = false;  ///< it may be a functional layer of the scenario, by --node
};

/// Parses the command line, reads the scenario, runs the node over DDS. Returns the exit code
/// (docs/exit-codes.md). Never throws.
int run_daemon_program(const DaemonProgram& program, int argc, char** argv);

}  // namespace skein::daemon_main
