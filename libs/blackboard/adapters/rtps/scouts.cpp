// SPDX-License-Identifier: Apache-2.0
#include "scouts.hpp"

#include <set>

namespace skein::blackboard::rtps {
namespace {

/// No channel is called so.
constexpr const char* kNobodyWrites = "nobody-writes-here";

}  // namespace

std::optional<LinkPlan> scouts_of(const std::vector<LinkPlan>& links, const DdsConfig& config) {
  if (config.network.discovery_servers.empty()) return std::nullopt;
  std::set<wire::Slot> slots;
  for (const LinkPlan& link : links)
    for (const wire::Slot slot : link.reads)
      if (link.waits_to_read(slot)) slots.insert(slot);
  if (slots.empty()) return std::nullopt;
  LinkPlan scouts;
  scouts.config.kind = ChannelKind::kRadio;
  scouts.config.partition = kNobodyWrites;
  scouts.reads.assign(slots.begin(), slots.end());
  return scouts;
}

}  // namespace skein::blackboard::rtps
