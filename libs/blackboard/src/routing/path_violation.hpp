// SPDX-License-Identifier: Apache-2.0
// Which ways samples may have come.
#pragma once

#include <map>
#include <optional>

#include "peer.hpp"
#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard::routing {

/// What ways are judged by.
struct PathRules {
  const Config& config;
  const Peers& peers;
  bool relays = false;  ///< there are some in the team
};

/// Why a sample may not have come over that radio channel; nothing: it may.
std::optional<wire::Violation> path_violation(const PathRules& rules, const ChannelConfig& channel,
                                              wire::Slot slot, const wire::SampleHeader& header);

/// It passed that node.
bool has_passed(const wire::SampleHeader& header, NodeNumber node);

}  // namespace skein::blackboard::routing
