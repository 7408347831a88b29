// SPDX-License-Identifier: Apache-2.0
// Inspection of a state file (SqliteInputLog), for `skein state`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "skein/node/input_log.hpp"
#include "skein/store/sqlite_input_log.hpp"

namespace skein::store {

/// Summary of a state file.
struct StateFile {
  Identity identity;
  int version = 0;           ///< of the format
  bool over = false;         ///< its mission is over
  bool complete = true;      ///< no handled input is missing
  bool of_this_wire = true;  ///< its samples have the wire layout of this program
  std::uint64_t inputs = 0, bytes = 0, lives = 0, lines = 0;
  MissionTime from, until;                       ///< of the inputs
  std::map<std::string, std::uint64_t> by_kind;  ///< inputs by kind: "received Telemetry", "wakeup"
};

/// Why the file cannot be read (absent, a folder, no permission), or empty if it can.
std::string unreadable(const std::filesystem::path& file);

/// Reads the whole file without changing it, also while a daemon uses it. The failure says what is
/// damaged, and at which input.
Result<StateFile, Failure> examine(const std::filesystem::path& file);

/// Calls `take` with each input, in order. The failure says what is damaged, and at which input.
Result<void, Failure> for_each_input(
    const std::filesystem::path& file,
    const std::function<void(std::uint64_t number, const node::LogEntry& entry)>& take);

}  // namespace skein::store
