// SPDX-License-Identifier: Apache-2.0
#include "directory.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::blackboard {

Directory::Directory(Config& config, Transport& transport)
    : config_(config), transport_(transport), no_session_(config) {}

Result<void, Failure> Directory::open() {
  for (std::size_t i = 0; i < config_.channels.size(); ++i) {
    if (auto added = add_channel(i); !added) return added;
  }
  for (const ChannelConfig& channel : config_.channels) senders_.push_back(find(channel.from));
  return {};
}

Result<void, Failure> Directory::add_channel(std::size_t index) {
  const ChannelConfig& channel = config_.channels[index];
  if (channel.kind == ChannelKind::kWorld) {
    if (world_) return failure("two world channels");
    world_ = index;
    return {};
  }
  if (channel.to == config_.self) return {};  // found from the other direction
  if (channel.from != config_.self) {
    return failure("channel " + channel.partition + " neither starts nor ends at this node");
  }
  const auto back = std::ranges::find_if(config_.channels, [&](const ChannelConfig& other) {
    return other.kind == channel.kind && other.from == channel.to && other.to == channel.from;
  });
  if (back == config_.channels.end()) return failure("no channel back for " + channel.partition);
  const auto incoming = static_cast<std::size_t>(back - config_.channels.begin());
  const PeerChannels channels{channel.to, channel.kind, index, incoming};
  const auto [added, fresh] = peers_.try_emplace(channel.to, channels, config_, no_session_);
  if (!fresh) return failure("two channels to node " + to_text(channel.to));
  plan(added->second);
  return {};
}

Peer* Directory::meet(NodeNumber number, Now now) {
  const auto known = peers_.find(number);
  if (known != peers_.end()) return &known->second;
  if (!config_.channels_with || number == config_.self) return nullptr;
  const std::vector<ChannelConfig> added = config_.channels_with(number);
  if (added.empty()) return nullptr;
  const std::size_t first = config_.channels.size();
  for (const ChannelConfig& channel : added) {
    const auto index = transport_.add(channel);
    SKEIN_ENSURES(index == config_.channels.size());
    config_.channels.push_back(channel);
  }
  for (std::size_t i = first; i < config_.channels.size(); ++i)
    SKEIN_ENSURES(add_channel(i).has_value());
  Peer& peer = peers_.at(number);
  for (const ChannelConfig& channel : added)
    senders_.push_back(channel.from == number ? &peer : nullptr);
  const ChannelCondition down{.up = false, .latency = {}};
  peer.set_outgoing(down, now);
  peer.set_incoming(down);
  plan(peer);
  return &peer;
}

Peer* Directory::find(NodeNumber number) {
  const auto found = peers_.find(number);
  return found == peers_.end() ? nullptr : &found->second;
}

const Peer* Directory::find(NodeNumber number) const {
  const auto found = peers_.find(number);
  return found == peers_.end() ? nullptr : &found->second;
}

Peer* Directory::origin(std::size_t channel, const wire::SampleHeader& header) {
  Peer* speaker = over(channel);
  if (speaker != nullptr && speaker->channels().number.value() == header.origin) return speaker;
  return find(NodeNumber(header.origin));
}

void Directory::plan(const Peer& peer) {
  agenda_.set(peer.channels().number, peer.next_wakeup(), peer.first_expiry());
}

}  // namespace skein::blackboard
