// SPDX-License-Identifier: Apache-2.0
// The folder of a run, as far as a replay needs it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/journal/record.hpp"

namespace skein::replay_tool {

struct Recording {
  std::string world;                     ///< for the page, with "replay": {"until": seconds}
  std::vector<journal::Record> records;  ///< in the order of time
  std::vector<std::string> uavs;         ///< in the order of the world
  std::size_t unreadable = 0;            ///< lines that were left out because they are wrong
  MissionTime until() const { return records.empty() ? MissionTime() : records.back().at(); }
};

/// The failure names the file and what is wrong with it.
Result<Recording, Failure> read_recording(const std::filesystem::path& folder);

}  // namespace skein::replay_tool
