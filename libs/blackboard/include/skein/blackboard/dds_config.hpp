// SPDX-License-Identifier: Apache-2.0
// Configuration of a transport over DDS, the same for all vendors.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "skein/blackboard/channel.hpp"
#include "skein/blackboard/handshakes.hpp"
#include "skein/blackboard/network.hpp"
#include "skein/blackboard/programs.hpp"

namespace skein::blackboard {

struct DdsConfig {
  std::uint32_t domain = 0;      ///< 0 to 100, so that its ports stay below the ephemeral ones
  std::string participant_name;  ///< shown by DDS tools
  NetworkConfig network;
  /// Receives the warnings and errors of the middleware, one line each, from any of its threads;
  /// they go nowhere else. Fast DDS has one log per process: the last transport opened receives it.
  std::function<void(const std::string&)> log;
  /// With keys: the names of the nodes, as in their certificates. A sample is malformed if its
  /// writer's certificate does not entitle it to the sample's origin. Empty: not checked (a spy).
  std::map<NodeNumber, std::string> names = {};
  /// Makes all endpoints at the beginning, so that they are discovered before they are used: for
  /// programs that write a few samples and end. Otherwise most are made when they are needed.
  bool endpoints_at_once = false;
  /// With keys, Fast DDS: receives the beginning and end of each authentication handshake. May be
  /// null.
  std::shared_ptr<Handshakes> handshakes = {};
  /// The fingerprint of the scenario that this node flies, for its program description; empty:
  /// none.
  std::string scenario = {};
  /// Receives the descriptions of the other participants. May be null.
  std::shared_ptr<Programs> programs = {};
};

}  // namespace skein::blackboard
