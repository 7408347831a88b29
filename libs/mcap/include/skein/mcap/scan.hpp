// SPDX-License-Identifier: Apache-2.0
// Reads MCAP files from the beginning to the end, whole or not.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "skein/mcap/format.hpp"

namespace skein::mcap {

struct ScanLimits {
  std::size_t chunk = 256 * 1024 * 1024;  ///< the greatest chunk, uncompressed [byte]
  std::size_t problems = 100;             ///< that are told; more are only counted
};

/// What a file holds beside its messages.
struct Contents {
  std::string profile, library;
  std::map<SchemaId, Schema> schemas;
  std::map<ChannelId, Channel> channels;
  std::map<std::string, std::map<std::string, std::string>> metadata;
  std::uint64_t messages = 0;
  bool begun = false;                 ///< it begins as an MCAP file does
  bool complete = false;              ///< it ends with a footer, as a file that was closed does
  std::vector<std::string> problems;  ///< for people, with offsets [byte]
  std::uint64_t more_problems = 0;
};

/// Calls `use` for every message, in the order of the file; its data and the channel are good until
/// it returns. Messages of channels that the file does not declare, and chunks whose checksum or
/// size is wrong, are problems, and left out. Cost: linear in the file, and a chunk of memory.
Contents scan(std::string_view file, const std::function<void(const Channel&, const Message&)>& use,
              const ScanLimits& limits = {});

}  // namespace skein::mcap
