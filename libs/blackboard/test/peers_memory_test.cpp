// SPDX-License-Identifier: Apache-2.0
// What a node holds of others that it has never heard.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/memory_transport.hpp"

namespace skein::blackboard {
namespace {

double in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// Sanitizers have an allocator of their own, of which mallinfo knows nothing.
bool is_counted() {
  const double before = in_use();
  const auto some = std::make_unique<std::vector<char>>(100'000);
  return in_use() > before && !some->empty();
}
constexpr const char* kNotCounted = "what is allocated is not counted here (a sanitizer)";

ChannelConfig radio(std::uint32_t from, std::uint32_t to) {
  ChannelConfig channel;
  channel.from = NodeNumber(from);
  channel.to = NodeNumber(to);
  channel.partition = "radio/u" + std::to_string(from) + ">u" + std::to_string(to);
  channel.slots = {wire::Slot::kTelemetry, wire::Slot::kTaskEvent};
  return channel;
}

// A team of n has the square of n pairs. Of a pair 3.2 kB were held while each had two empty queues
// and both channels all that a writer may keep, 1.5 while each had a session.
TEST(PeersMemory, APeerThatWasNeverHeardTakesAKilobyteWithItsChannels) {
  if (!is_counted()) GTEST_SKIP() << kNotCounted;
  constexpr std::uint32_t kPeers = 1'000;
  MemoryHub hub;
  MemoryTransport transport(hub);
  Config config;
  config.self = NodeNumber(1);
  config.incarnation = 1;
  config.heartbeat_period = Duration::seconds(1);
  for (std::uint32_t peer = 2; peer < 2 + kPeers; ++peer) {
    config.channels.push_back(radio(1, peer));
    config.channels.push_back(radio(peer, 1));
  }
  const double before = in_use();

  const auto board = Blackboard::open(std::move(config), transport);

  ASSERT_TRUE(board.has_value());
  const double each = (in_use() - before) / kPeers;
  std::printf("%.0f bytes a peer\n", each);
  EXPECT_LT(each, 1'000);
}

/// A node of a team in which others may come into reach.
class LazyNode {
 public:
  LazyNode(MemoryHub& hub, std::uint32_t number) : transport_(hub) {
    Config config;
    config.self = NodeNumber(number);
    config.incarnation = 1;
    config.heartbeat_period = Duration::seconds(1);
    config.channels_with = [number](NodeNumber other) {
      return std::vector{radio(number, other.value()), radio(other.value(), number)};
    };
    board_.emplace(std::move(*Blackboard::open(std::move(config), transport_)));
  }
  Blackboard& board() { return *board_; }

 private:
  MemoryTransport transport_;
  std::optional<Blackboard> board_;
};

/// The link between two nodes, as both are told.
void connect(LazyNode& a, std::uint32_t of_a, LazyNode& b, std::uint32_t of_b, bool up, Now now) {
  const ChannelCondition condition{.up = up, .latency = {}};
  for (LazyNode* node : {&a, &b}) {
    node->board().set_condition(NodeNumber(of_a), NodeNumber(of_b), condition, now);
    node->board().set_condition(NodeNumber(of_b), NodeNumber(of_a), condition, now);
  }
}

TEST(PeersMemory, ChannelsAreMadeWhenALinkComesUp) {
  MemoryHub hub;
  LazyNode a(hub, 1), b(hub, 2);
  EXPECT_EQ(a.board().channels(), 0U);

  connect(a, 1, b, 2, false, {});
  EXPECT_EQ(a.board().channels(), 0U) << "of what is down nothing is kept";
  connect(a, 1, b, 2, true, {});

  EXPECT_EQ(a.board().channels(), 2U);
  for (int round = 0; round < 4; ++round)
    for (LazyNode* node : {&a, &b}) node->board().step({});
  EXPECT_TRUE(a.board().reachable(NodeNumber(2)));
  EXPECT_TRUE(b.board().reachable(NodeNumber(1)));
}

TEST(PeersMemory, WhatIsSentToOneThatIsNotInReachWaitsForTheLink) {
  MemoryHub hub;
  LazyNode a(hub, 1), b(hub, 2);
  ASSERT_TRUE(a.board().send(wire::TaskEvent{}, NodeNumber(2), {}));
  ASSERT_TRUE(a.board().send(wire::Telemetry{}, NodeNumber(2), {}));

  std::size_t received = 0;
  const auto run = [&] {
    for (int round = 0; round < 6; ++round)
      for (LazyNode* node : {&a, &b})
        for (const Incoming& one : node->board().step({}))
          received += std::holds_alternative<Received>(one) ? 1 : 0;
  };
  run();
  EXPECT_EQ(received, 0U);
  connect(a, 1, b, 2, true, {});
  run();

  EXPECT_EQ(received, 1U) << "the event; the stream is of the past";
}

/// Bytes that a node of a team takes of which the next six on either side, in a ring, are in reach.
double bytes_of_one_among(std::uint32_t nodes) {
  constexpr std::uint32_t kBeside = 6;
  const double before = in_use();
  MemoryHub hub;
  std::vector<std::unique_ptr<LazyNode>> team;
  for (std::uint32_t i = 0; i < nodes; ++i) team.push_back(std::make_unique<LazyNode>(hub, i + 1));
  for (std::uint32_t i = 0; i < nodes; ++i) {
    for (std::uint32_t k = 1; k <= kBeside; ++k) {
      const std::uint32_t other = (i + k) % nodes;
      connect(*team[i], i + 1, *team[other], other + 1, true, {});
    }
  }
  for (int round = 0; round < 6; ++round)
    for (const auto& node : team) (void)node->board().step({});
  return (in_use() - before) / nodes;
}

TEST(PeersMemory, ANodeTakesWhatThoseInReachTakeHoweverManyThereAre) {
  if (!is_counted()) GTEST_SKIP() << kNotCounted;
  (void)bytes_of_one_among(30);  // what is allocated once
  const double few = bytes_of_one_among(30);
  const double many = bytes_of_one_among(1'000);

  std::printf("%.0f bytes a node among 30, %.0f among 1,000\n", few, many);
  EXPECT_NEAR(many / few, 1, 0.1);
}

}  // namespace
}  // namespace skein::blackboard
