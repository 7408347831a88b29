// SPDX-License-Identifier: Apache-2.0
// What a transport over DDS is told, whatever the vendor.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>

#include "skein/blackboard/channel.hpp"
#include "skein/blackboard/network.hpp"

namespace skein::blackboard {

/// A sample as it came, malformed or not.
struct RawSample {
  wire::Slot slot = wire::Slot::kHeartbeat;
  std::string partition;                ///< of its writer; empty if it is in none
  std::int64_t source_time = 0;         ///< of its writer [ns since 1970]
  std::span<const std::uint8_t> bytes;  ///< CDR behind its 4-byte header
};

struct DdsConfig {
  std::uint32_t domain = 0;      ///< 0 to 100, so that its ports stay below the ephemeral ones
  std::string participant_name;  ///< shown by DDS tools
  NetworkConfig network;
  /// Warnings and errors of the middleware, one line each, from any of its threads; they go nowhere
  /// else. The log of Fast DDS is one per process: the last transport opened receives it.
  std::function<void(const std::string&)> log;
  /// With keys: who has which number. A sample that says it is of a node whose certificate its
  /// writer does not have is malformed. Empty: that is not checked (a spy).
  std::map<NodeNumber, std::string> names = {};
  /// Told of every sample that is taken from a reader, from any of the middleware's threads: for
  /// recorders.
  std::function<void(const RawSample&)> tap = {};
};

}  // namespace skein::blackboard
