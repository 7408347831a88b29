// SPDX-License-Identifier: Apache-2.0
// A small system of blackboards over one kind of transport.
#include "testing/system.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace skein::blackboard::testing {
namespace {

constexpr Duration kPatience = Duration::milliseconds(30'000);

std::vector<ChannelConfig> channels_of(const Node& node) {
  std::vector<ChannelConfig> channels;
  const auto add = [&](const std::vector<ChannelConfig>& link) {
    channels.insert(channels.end(), link.begin(), link.end());
  };
  if (node.number != kSim.number) add(station_link(kGround, kMarvin));
  if (node.number != kGround.number) add(onboard_link(kMarvin, kSim));
  channels.push_back(world_channel());
  return channels;
}

}  // namespace

void System::start_process(NodeNumber process, const Node& node) {
  nodes_.erase(process);
  Config config;
  config.self = node.number;
  config.incarnation = ++incarnations_[node.number];
  config.channels = channels_of(node);
  config.world_reads = world_channel().slots;
  config.held_events = held_events;
  Running& running = nodes_[process];
  running.transport = medium_->transport(node.name);
  auto opened = Blackboard::open(std::move(config), *running.transport);
  ASSERT_TRUE(opened) << opened.error().why;
  running.blackboard = std::make_unique<Blackboard>(std::move(*opened));
}

void System::set_condition(const Node& from, const Node& to, const ChannelCondition& condition) {
  for (const Node& end : {from, to}) {
    const auto node = nodes_.find(end.number);
    if (node == nodes_.end()) continue;
    node->second.blackboard->set_condition(from.number, to.number, condition, now());
  }
}

void System::set_link(const Node& a, const Node& b, bool up) {
  const ChannelCondition condition{.up = up, .latency = {}, .loss = 0};
  set_condition(a, b, condition);
  set_condition(b, a, condition);
}

void System::step_all() {
  for (auto& [number, node] : nodes_) {
    for (Incoming& incoming : node.blackboard->step(now())) {
      node.received.push_back(std::move(incoming));
    }
  }
}

bool System::run_until(const std::function<bool()>& condition) {
  const Duration deadline = medium_->steady() + kPatience;
  while (true) {
    step_all();
    if (condition()) return true;
    if (medium_->steady() >= deadline) return false;
    Duration wakeup = medium_->steady() + Duration::milliseconds(20);
    for (const auto& [number, node] : nodes_) {
      if (const auto due = node.blackboard->next_wakeup()) wakeup = std::min(wakeup, *due);
    }
    medium_->wait(wakeup);
  }
}

bool System::run_until_reachable(const Node& a, const Node& b, bool reachable) {
  return run_until([&] {
    const auto agrees = [&](const Node& from, const Node& to) {
      return !nodes_.contains(from.number) || (*this)[from].reachable(to.number) == reachable;
    };
    return agrees(a, b) && agrees(b, a);
  });
}

}  // namespace skein::blackboard::testing
