// SPDX-License-Identifier: Apache-2.0
// What the daemons' mains share: options, scenario, logging, running.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/node/companion.hpp"
#include "skein/node/node.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::daemon_main {

/// An option that one program has beside those of all; like those, from the command line, the
/// environment or a file.
struct OwnOption {
  std::string name;  ///< "--connect"
  std::string help;
  std::string* value;  ///< what it holds is the default; outlives the run
};

/// The node of a program that makes it itself.
struct Crew {
  std::string name;  ///< of the node in the roster
  std::unique_ptr<node::Node> node;
  std::unique_ptr<node::Companion> companion;  ///< may be null
};

struct DaemonProgram {
  std::string name;         ///< "skein-ddn"
  std::string description;  ///< one line for --help
  std::string node;         ///< the node it runs: "ground", "sim"; empty: the UAV given by --uav
  bool plays_vehicles = false;  ///< it may be a functional layer of the scenario, by --node
  std::vector<OwnOption> options = {};
  /// Makes the node of a UAV, which keeps no memory; the failure says what is wrong with the input.
  /// Empty: the node is that of assembly.
  std::function<Result<Crew, Failure>(const scenario::Scenario&, const std::string& uav)> crew = {};
};

/// Parses the command line, reads the scenario, runs the node over DDS. Returns the exit code
/// (docs/exit-codes.md). Never throws.
int run_daemon_program(const DaemonProgram& program, int argc, char** argv);

}  // namespace skein::daemon_main
