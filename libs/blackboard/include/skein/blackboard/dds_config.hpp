// SPDX-License-Identifier: Apache-2.0
// What a transport over DDS is told, whatever the vendor.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "skein/blackboard/channel.hpp"
#include "skein/blackboard/handshakes.hpp"
#include "skein/blackboard/network.hpp"

namespace skein::blackboard {

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
  /// All endpoints are made at the beginning, so that others can find them before they are used:
  /// for programs that write what they have and end. Else most are made when they are needed.
  bool endpoints_at_once = false;
  /// With keys, Fast DDS: told of all that are found, and of those who have proved who they are.
  /// Null: nobody wants to know.
  std::shared_ptr<Handshakes> handshakes = {};
};

}  // namespace skein::blackboard
