// SPDX-License-Identifier: Apache-2.0
// Plays a scenario with its daemons over DDS.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "progress.hpp"
#include "skein/blackboard/network.hpp"
#include "skein/run_tool/played.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::run_tool {

struct DdsOptions {
  std::string daemons;  ///< folder of the programs; empty: that of this program
  std::string folder;   ///< for the daemons' logs, in logs/
  std::optional<std::uint32_t> domain;
  std::vector<std::string> daemon_options;   ///< handed to every daemon
  std::vector<std::string> without = {};     ///< nodes that somebody else starts
  std::string keys = {};                     ///< folder of make-keys; empty: no security
  bool types = false;                        ///< announced by nodes on Cyclone DDS
  std::string console = {};                  ///< of the ground station; empty: none
  std::string mavlink_out = {};              ///< of the ground station; empty: none
  std::optional<std::uint32_t> ros2 = {};    ///< domain, of the ground station; none: nobody
  std::vector<std::string> interfaces = {};  ///< to talk on; empty: this machine alone
};

/// Whether a node can: one on Cyclone DDS.
inline bool announces_types(const scenario::Scenario& scenario, const std::string& node) {
  return scenario.dds_of(node) == blackboard::name_of(blackboard::DdsVendor::kCycloneDds);
}

/// Starts the daemons, follows the run over the world channel, kills and restarts daemons as the
/// scenario says, and leaves no process behind, however it ends.
Played play_dds(const scenario::Scenario& scenario, const DdsOptions& options, Progress& progress);

}  // namespace skein::run_tool
