// SPDX-License-Identifier: Apache-2.0
// What of a daemon outlives its process.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "skein/scenario_setup/overrides.hpp"
#include "skein/store/sqlite_input_log.hpp"

namespace skein::daemon_main {

struct Memory {
  std::unique_ptr<store::SqliteInputLog> log;  ///< null: nothing outlives the process
  std::vector<std::string> notices;            ///< for the log
  std::uint64_t incarnation = 0;               ///< of this process; 0: of the clock
};

/// Opens the memory of a node in a folder, or begins one. What cannot be gone on from is set aside,
/// where nothing can be kept the daemon works without; both are said in the notices: a vehicle in
/// the air is not to wait for somebody who mends a disk. Whether the node can have been given what
/// is there shows when it is given it.
Memory open_memory(const std::string& folder, const store::Identity& identity);

struct Refused {
  std::vector<std::string> notices;  ///< for the log
  bool again = false;                ///< another memory is begun in its place
};
/// The node, given what is there, is not what wrote it: it is set aside, with the reason.
Refused refuse(store::SqliteInputLog& log, const std::string& node, const std::string& why);

/// Changes when the scenario file does, or what is laid over it.
std::string identity_of_mission(const std::string& scenario_file,
                                const scenario_setup::Overrides& overrides);

}  // namespace skein::daemon_main
