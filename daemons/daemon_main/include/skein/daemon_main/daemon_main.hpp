// SPDX-License-Identifier: Apache-2.0
// Common main program of the daemons: options, scenario, logging, running.
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

/// An additional option of one program; like the common ones from the command line, the environment
/// or a file.
struct OwnOption {
  std::string name;  ///< "--connect"
  std::string help;
  std::string* value;  ///< initially the default; must outlive the run
};

/// A node made by the program itself (DaemonProgram::crew), with its companion.
struct Crew {
  std::string name;  ///< of the node in the roster
  std::unique_ptr<node::Node> node;
  std::unique_ptr<node::Companion> companion;  ///< may be null
};

/// Start-up information of a program, for companion sources.
struct Surroundings {
  std::string scenario_file;
  const scenario::Scenario& scenario;
  const blackboard::NetworkConfig& network;
};

/// Factory of a companion of a program's node (operators' page, foreign ground station), with its
/// own options, which like the common ones come from the command line, the environment or a file.
class CompanionSource {
 public:
  struct Opened {
    std::unique_ptr<node::Companion> companion;
    std::string notice;  ///< for the log
  };

  virtual ~CompanionSource() = default;
  virtual void declare(CLI::App& app) = 0;
  /// Opens the companion; none if its options do not ask for one. The failure names the wrong
  /// option.
  virtual Result<Opened, Failure> open(const Surroundings& surroundings) = 0;
};

struct DaemonProgram {
  std::string name;         ///< "skein-ddn"
  std::string description;  ///< one line for --help
  std::string node;         ///< the node it runs: "ground", "sim"; empty: the UAV given by --uav
  bool plays_vehicles = false;  ///< the program can run a functional layer of the scenario (--node)
  std::vector<OwnOption> options = {};
  /// Checks the scenario for the node; returns all problems at once.
  std::function<Diagnostics(const scenario::Scenario&)> check = {};
  /// Makes the node of this name; called a second time for a node that replays the inputs in
  /// --state.
  std::function<std::unique_ptr<node::Node>(const scenario::Scenario&, const std::string& name)>
      make = {};
  std::vector<CompanionSource*> companions = {};  ///< outlive the run
  /// Instead of `make`: makes the node of a UAV, without persistent state; the failure describes
  /// the error in the input.
  std::function<Result<Crew, Failure>(const scenario::Scenario&, const std::string& uav)> crew = {};
};

/// Parses the command line, reads the scenario, runs the node over DDS. Returns the exit code
/// (docs/exit-codes.md). Never throws.
int run_daemon_program(const DaemonProgram& program, int argc, char** argv);

}  // namespace skein::daemon_main
