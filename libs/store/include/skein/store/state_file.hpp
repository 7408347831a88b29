// SPDX-License-Identifier: Apache-2.0
// A state file looked at from outside: `skein state`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "skein/node/input_log.hpp"
#include "skein/store/sqlite_input_log.hpp"

namespace skein::store {

/// What is in a state file.
struct StateFile {
  Identity identity;
  int version = 0;           ///< of the format
  bool over = false;         ///< its mission is
  bool complete = true;      ///< nothing that was handled is missing
  bool of_this_wire = true;  ///< its messages are those of this program
  std::uint64_t inputs = 0, bytes = 0, lives = 0, lines = 0;
  MissionTime from, until;                       ///< of the inputs
  std::map<std::string, std::uint64_t> by_kind;  ///< inputs by kind: "received Telemetry", "wakeup"
};

/// Why there is no file there that could be read: none, a folder, no right to; empty if there is.
std::string unreadable(const std::filesystem::path& file);

/// Reads all of it, without changing anything, while a daemon uses it too or not. The failure says
/// what is damaged, and at which input.
Result<StateFile, Failure> examine(const std::filesystem::path& file);

/// Each input in its order. Failure as above.
Result<void, Failure> for_each_input(
    const std::filesystem::path& file,
    const std::function<void(std::uint64_t number, const node::LogEntry& entry)>& take);

}  // namespace skein::store
