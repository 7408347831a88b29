// SPDX-License-Identifier: Apache-2.0
// What the daemons' mains share: options, scenario, logging, running.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "skein/blackboard/network.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/node/companion.hpp"
#include "skein/node/node.hpp"
#include "skein/scenario/scenario.hpp"

namespace CLI {
class App;
}

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

/// What a program is started with, for those who open something beside its node.
struct Surroundings {
  std::string scenario_file;
  const scenario::Scenario& scenario;
  const blackboard::NetworkConfig& network;
};

/// Somebody beside the node of a program (a page for operators, a station of others), with options
/// of its own that, like those of all, come from the command line, the environment or a file.
class CompanionSource {
 public:
  struct Opened {
    std::unique_ptr<node::Companion> companion;
    std::string notice;  ///< for the log
  };

  virtual ~CompanionSource() = default;
  virtual void declare(CLI::App& app) = 0;
  /// No companion: it was not asked for. The failure names the option that is wrong.
  virtual Result<Opened, Failure> open(const Surroundings& surroundings) = 0;
};

struct DaemonProgram {
  std::string name;         ///< "skein-ddn"
  std::string description;  ///< one line for --help
  std::string node;         ///< the node it runs: "ground", "sim"; empty: the UAV given by --uav
  bool plays_vehicles = false;  ///< it may be a functional layer of the scenario, by --node
  std::vector<OwnOption> options = {};
  /// What its node would find wrong with the scenario: every problem at once.
  std::function<Diagnostics(const scenario::Scenario&)> check = {};
  /// Makes the node of this name; called again for one to try on what --state has kept.
  std::function<std::unique_ptr<node::Node>(const scenario::Scenario&, const std::string& name)>
      make = {};
  std::vector<CompanionSource*> companions = {};  ///< outlive the run
  /// In place of `make`: makes the node of a UAV, which keeps no memory; the failure says what is
  /// wrong with the input.
  std::function<Result<Crew, Failure>(const scenario::Scenario&, const std::string& uav)> crew = {};
};

/// Parses the command line, reads the scenario, runs the node over DDS. Returns the exit code
/// (docs/exit-codes.md). Never throws.
int run_daemon_program(const DaemonProgram& program, int argc, char** argv);

}  // namespace skein::daemon_main
