// SPDX-License-Identifier: Apache-2.0
#include "adapters/rtps/scouts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "skein/blackboard/observer.hpp"

namespace skein::blackboard::rtps {
namespace {

using ::testing::Contains;
using ::testing::Not;
using wire::Slot;

const Node kUavOfTwo{NodeNumber(1), "marvin"}, kOther{NodeNumber(2), "karma"},
    kStation{NodeNumber(3), "ground"};

std::vector<LinkPlan> links_of_marvin(const DdsConfig& config) {
  TransportPlan plan{kUavOfTwo.number, {world_channel()}, {Slot::kClock}};
  for (const ChannelConfig& one : radio_link(kUavOfTwo, kOther)) plan.channels.push_back(one);
  for (const ChannelConfig& one : station_link(kStation, kUavOfTwo)) plan.channels.push_back(one);
  std::vector<LinkPlan> links;
  for (std::size_t i = 0; i < plan.channels.size(); ++i)
    links.push_back(plan_link(plan, i, config));
  return links;
}

DdsConfig behind_a_server() {
  DdsConfig config;
  config.network.discovery_servers = {"10.0.0.1:11811"};
  return config;
}

TEST(Scouts, AreOneForEachSlotThatSomeReaderWaitsForAndDoNotWait) {
  const auto links = links_of_marvin(behind_a_server());
  const auto scouts = scouts_of(links, behind_a_server());
  ASSERT_TRUE(scouts.has_value());
  for (const LinkPlan& link : links) {
    for (const Slot slot : link.reads) {
      if (!link.waits_to_read(slot)) continue;
      EXPECT_EQ(std::ranges::count(scouts->reads, slot), 1) << wire::slot_name(slot);
      EXPECT_FALSE(scouts->waits_to_read(slot));
    }
  }
  EXPECT_THAT(scouts->reads, Not(Contains(Slot::kHeartbeat))) << "its reader is there anyway";
  EXPECT_THAT(scouts->reads, Not(Contains(Slot::kClock)));
  EXPECT_TRUE(scouts->writes.empty());
}

TEST(Scouts, AreWhereNobodyWrites) {
  const auto links = links_of_marvin(behind_a_server());
  const auto scouts = scouts_of(links, behind_a_server());
  ASSERT_TRUE(scouts.has_value());
  for (const LinkPlan& link : links)
    EXPECT_FALSE(partitions_meet({scouts->config.partition}, {link.config.partition}));
}

TEST(Scouts, AreNotNeededWithoutAServerNorWhereNothingWaits) {
  EXPECT_FALSE(scouts_of(links_of_marvin({}), {}).has_value());
  DdsConfig at_once = behind_a_server();
  at_once.endpoints_at_once = true;
  EXPECT_FALSE(scouts_of(links_of_marvin(at_once), at_once).has_value());
}

}  // namespace
}  // namespace skein::blackboard::rtps
