// SPDX-License-Identifier: Apache-2.0
// One reader for what all peers say over radio to be heard.
#include "heartbeat_reader.hpp"

#include <algorithm>
#include <string_view>

#include "skein/foundation/contract.hpp"

namespace skein::blackboard::rtps {
namespace {

/// "radio/*>marvin" for "radio/karma>marvin"; empty: it is named otherwise, as a spy's pattern.
std::string from_anybody(std::string_view partition) {
  const std::size_t arrow = partition.find('>');
  if (arrow == partition.npos || !partition.starts_with("radio/") || is_pattern(partition))
    return {};
  return "radio/*" + std::string(partition.substr(arrow));
}

}  // namespace

std::optional<HeartbeatReader> HeartbeatReader::of(const TransportPlan& plan,
                                                   const DdsConfig& config) {
  if (!config.network.keys.empty() || config.endpoints_at_once) return std::nullopt;
  HeartbeatReader reader;
  for (std::size_t i = 0; i < plan.channels.size(); ++i) {
    const ChannelConfig& channel = plan.channels[i];
    if (channel.kind != ChannelKind::kRadio || channel.to != plan.self) continue;
    const std::string all = from_anybody(channel.partition);
    if (all.empty()) continue;
    std::string& partition = reader.link_.config.partition;
    if (partition.empty()) partition = all;
    if (partition == all) reader.channels_.emplace(channel.from, i);
  }
  if (reader.channels_.empty()) return std::nullopt;
  reader.link_.config.to = plan.self;
  reader.link_.config.kind = ChannelKind::kRadio;
  reader.link_.reads = {wire::Slot::kHeartbeat};
  return reader;
}

bool HeartbeatReader::covers(std::size_t channel) const {
  return std::ranges::any_of(channels_, [&](const auto& one) { return one.second == channel; });
}

std::size_t HeartbeatReader::channel_of(const Arrival& arrival) const {
  SKEIN_EXPECTS(!channels_.empty());
  const auto* sample = std::get_if<wire::Sample>(&arrival.content);
  const wire::SampleHeader& header =
      sample != nullptr ? wire::header_of(*sample) : std::get<Malformed>(arrival.content).header;
  const NodeNumber from(header.via.empty() ? header.origin : header.via.back());
  const auto found = channels_.find(from);
  return found == channels_.end() ? channels_.begin()->second : found->second;
}

}  // namespace skein::blackboard::rtps
