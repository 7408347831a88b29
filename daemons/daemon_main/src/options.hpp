// SPDX-License-Identifier: Apache-2.0
// The options that all daemons take.
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
  std::string config;  ///< file with the others; empty: none
  bool show_config = false;
  bool show_rights = false;
  std::string manual;  ///< to print instead of running: "man", or the name of a shell
  std::string scenario;
  std::string node;  ///< empty: that of the program
  std::uint32_t domain = 0;
  blackboard::NetworkConfig network;
  scenario_setup::Overrides overrides;
  std::string state;   ///< empty: nothing outlives the process
  std::string log_to;  ///< file of its event log; empty: none
  bool world = true;   ///< whether it takes part in the world channel
  std::string log_level = "info";
  bool log_json = false;
  bool forgets = false;  ///< of what is there it takes only where its vehicles are
  int parent = 0;        ///< process that it must not outlive; 0: none
};

/// Declares all of them at a program's command line, writing to `options`.
void declare(CLI::App& app, Options& options, const DaemonProgram& program);

/// Fills what the command line left open from environment and file. Every problem, also what is
/// required and was nowhere; `shown` gets the text of --show-config.
Diagnostics complete(CLI::App& app, Options& options, const DaemonProgram& program,
                     std::string& shown);

}  // namespace skein::daemon_main
