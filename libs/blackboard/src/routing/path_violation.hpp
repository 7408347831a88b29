// SPDX-License-Identifier: Apache-2.0
// Check of the path that a sample has taken.
#pragma once

#include <map>
#include <optional>

#include "peer.hpp"
#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard::routing {

/// What the check depends on.
struct PathRules {
  const Config& config;
  const Peers& peers;
  bool relays = false;  ///< whether the system has relays
};

/// Why a sample with this header cannot have come over this radio channel; nothing if it can.
std::optional<wire::Violation> path_violation(const PathRules& rules, const ChannelConfig& channel,
                                              wire::Slot slot, const wire::SampleHeader& header);

/// Whether the sample was relayed by that node.
bool has_passed(const wire::SampleHeader& header, NodeNumber node);

}  // namespace skein::blackboard::routing
