// SPDX-License-Identifier: Apache-2.0
// The persistent state of a daemon's node.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "skein/scenario/scenario.hpp"
#include "skein/store/sqlite_input_log.hpp"

namespace skein::daemon_main {

struct Memory {
  std::unique_ptr<store::SqliteInputLog> log;  ///< null: nothing is persistent
  std::vector<std::string> notices;            ///< for the log
  std::uint64_t incarnation = 0;               ///< of this process; 0: of the clock
  bool first_life = false;                     ///< the folder knows of no life before this one
  std::string in_use;  ///< why this process must not be the node: another one is; else empty
};

/// Opens or creates the memory of a node in a folder. A memory that cannot be continued is set
/// aside; if none can be kept the daemon works without, since a vehicle in flight cannot wait for
/// the repair of a disk. Both are reported in the notices. A memory that another process uses is
/// that of the node itself, which runs already: nothing is changed then. Whether the stored inputs
/// fit the node only shows when they are replayed (refuse()).
Memory open_memory(const std::string& folder, const store::Identity& identity);

struct Refused {
  std::vector<std::string> notices;  ///< for the log
  bool again = false;                ///< another memory is begun in its place
};
/// Sets aside a memory whose replay showed that it does not belong to this node, with the reason.
Refused refuse(store::SqliteInputLog& log, const std::string& node, const std::string& why);

/// Identity of a mission; it changes with what its scenario says.
std::string identity_of_mission(const scenario::Scenario& scenario);

}  // namespace skein::daemon_main
