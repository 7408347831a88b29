// SPDX-License-Identifier: Apache-2.0
// Options common to all daemons.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "skein/blackboard/network.hpp"
#include "skein/daemon_main/daemon_main.hpp"
#include "skein/scenario_setup/overrides.hpp"

namespace skein::daemon_main {

struct Options {
  std::string config;  ///< file with further options; empty: none
  bool show_config = false;
  bool show_rights = false;
  std::string manual;  ///< to print instead of running: "man", or the name of a shell
  std::string scenario;
  std::string node;  ///< empty: the default node of the program
  std::uint32_t domain = 0;
  blackboard::NetworkConfig network;
  scenario_setup::Overrides overrides;
  std::string state;   ///< folder of persistent state; empty: none
  std::string log_to;  ///< file of the event log; empty: none
  bool world = true;   ///< whether the node takes part in the world channel
  std::string log_level = "info";
  bool log_json = false;
  bool forgets = false;  ///< restores only the positions of its vehicles from the persistent state
  int parent = 0;        ///< process id with which the daemon has to end; 0: none
};

/// Declares all of them at a program's command line, writing to `options`.
void declare(CLI::App& app, Options& options, const DaemonProgram& program);

/// Completes the options from environment and file. Returns all problems, including missing
/// required options; `shown` gets the text of --show-config.
Diagnostics complete(CLI::App& app, Options& options, const DaemonProgram& program,
                     std::string& shown);

}  // namespace skein::daemon_main
