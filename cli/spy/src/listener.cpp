// SPDX-License-Identifier: Apache-2.0
#include "listener.hpp"

#include <algorithm>

#include "skein/foundation/nearest.hpp"

namespace skein::spy_tool {

namespace {

using blackboard::NodeNumber;

/// Of no node: what is sent to it, and what it would send, does not exist.
constexpr std::uint32_t kSpyNumber = 4'000'000'000;
constexpr std::uint32_t kNobody = 4'000'000'001;

std::vector<std::string> slot_names() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < wire::kSlotCount; ++i) {
    names.emplace_back(wire::slot_name(static_cast<wire::Slot>(i)));
  }
  return names;
}

std::uint32_t origin_of(const std::variant<wire::Sample, blackboard::Malformed>& content) {
  if (const auto* sample = std::get_if<wire::Sample>(&content)) {
    return wire::header_of(*sample).origin;
  }
  return std::get<blackboard::Malformed>(content).header.origin;
}

wire::Slot slot_of(const std::variant<wire::Sample, blackboard::Malformed>& content) {
  if (const auto* sample = std::get_if<wire::Sample>(&content)) return wire::slot_of(*sample);
  return std::get<blackboard::Malformed>(content).slot;
}

}  // namespace

Diagnostics Listener::check() const {
  Diagnostics diagnostics;
  const std::vector<std::string> known = slot_names();
  for (const std::string& slot : options_.slots) {
    if (std::find(known.begin(), known.end(), slot) != known.end()) continue;
    std::string all;
    for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
    diagnostics.add(
        {"", 0, 0, "", "no slot '" + slot + "'", "one of " + all, nearest_name(slot, known)});
  }
  return diagnostics;
}

Result<void, Failure> Listener::open() {
  transport_ =
      blackboard::make_dds_transport({options_.domain, "spy", options_.network, {}, {}, tap_});
  transport_->on_arrival([this] { waker_.notify(); });
  blackboard::TransportPlan plan;
  plan.self = NodeNumber(kSpyNumber);
  for (const std::string& partition : options_.partitions) {
    blackboard::ChannelConfig channel;
    channel.from = NodeNumber(kNobody);
    channel.to = plan.self;
    channel.kind = blackboard::ChannelKind::kRadio;
    channel.partition = partition;
    for (std::size_t i = 0; i < wire::kSlotCount; ++i) {
      const auto slot = static_cast<wire::Slot>(i);
      const bool for_names = slot == wire::Slot::kDirectoryEntry;
      const bool implied =
          slot == wire::Slot::kHeartbeat;  // on every channel that is not the world
      if ((wanted(slot) || for_names) && !implied) channel.slots.push_back(slot);
    }
    plan.channels.push_back(std::move(channel));
  }
  return transport_->open(plan);
}

bool Listener::wanted(wire::Slot slot) const {
  return options_.slots.empty() || std::find(options_.slots.begin(), options_.slots.end(),
                                             wire::slot_name(slot)) != options_.slots.end();
}

void Listener::listen(std::optional<Duration> until, const std::function<bool(const Heard&)>& use) {
  while (!waker_.stop_requested()) {
    for (const blackboard::Arrival& arrival : transport_->take()) {
      if (!hear(arrival, use)) return;
    }
    const Duration now = node::Waker::steady_now();
    if (until && now >= *until) return;
    waker_.wait(until ? std::optional<Duration>(*until - now) : std::nullopt);
  }
}

bool Listener::hear(const blackboard::Arrival& arrival,
                    const std::function<bool(const Heard&)>& use) {
  const auto* sample = std::get_if<wire::Sample>(&arrival.content);
  const auto* entry = sample == nullptr ? nullptr : std::get_if<wire::DirectoryEntry>(sample);
  const std::uint32_t origin = origin_of(arrival.content);
  if (entry != nullptr) directory_.insert_or_assign(origin, *entry);
  if (!wanted(slot_of(arrival.content))) return true;
  const bool from_wanted = options_.from.empty() || options_.from == name_of(origin) ||
                           options_.from == std::to_string(origin);
  if (!from_wanted) return true;
  return use({node::Waker::steady_now(), arrival.content});
}

std::string Listener::name_of(std::uint32_t number) const {
  const auto found = directory_.find(number);
  return found == directory_.end() ? "node " + std::to_string(number) : found->second.name;
}

}  // namespace skein::spy_tool
