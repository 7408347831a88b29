// SPDX-License-Identifier: Apache-2.0
#include "routing/path_violation.hpp"

#include <algorithm>
#include <utility>

namespace skein::blackboard::routing {

bool has_passed(const wire::SampleHeader& header, NodeNumber node) {
  return std::ranges::find(header.via, node.value()) != header.via.end();
}

std::optional<wire::Violation> path_violation(const PathRules& rules, const ChannelConfig& channel,
                                              wire::Slot slot, const wire::SampleHeader& header) {
  const bool mine = header.destination == rules.config.self.value();
  if (header.via.empty()) {
    if (header.origin != channel.from.value())
      return wire::Violation{"header.origin", "not a node of channel " + channel.partition};
    if (!mine || channel.originates(slot)) return std::nullopt;
    return wire::Violation{"header.origin", "has nothing of its own to say in this slot"};
  }
  const auto wrong = [](std::string why) { return wire::Violation{"header.via", std::move(why)}; };
  if (header.via.back() != channel.from.value())
    return wrong("does not end with the sender of channel " + channel.partition);
  if (!rules.relays || !channel.relays(slot))
    return wrong("channel " + channel.partition + " carries nothing of others in this slot");
  if (header.via.size() > rules.config.relaying.most_relays) return wrong("too many relays");
  const auto origin = rules.peers.find(NodeNumber(header.origin));
  if (origin == rules.peers.end() || has_passed(header, origin->first))
    return wire::Violation{"header.origin", "not a node whose samples are passed on"};
  if (!mine || rules.config.channels[origin->second.channels().incoming].originates(slot))
    return std::nullopt;
  return wire::Violation{"header.origin", "has nothing to say to this node in this slot"};
}

}  // namespace skein::blackboard::routing
