// SPDX-License-Identifier: Apache-2.0
// What a node holds of others that it has never heard.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdio>
#include <string>
#include <utility>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/memory_transport.hpp"

namespace skein::blackboard {
namespace {

double in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

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

}  // namespace
}  // namespace skein::blackboard
