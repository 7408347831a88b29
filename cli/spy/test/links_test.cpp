// SPDX-License-Identifier: Apache-2.0
#include "links.hpp"

#include <gtest/gtest.h>

namespace skein::spy_tool {
namespace {

Duration at(double seconds) { return Duration::seconds(seconds); }

wire::Heartbeat heartbeat(std::uint32_t from, std::uint32_t to, std::uint64_t incarnation = 1) {
  wire::Heartbeat one;
  one.header.origin = from;
  one.header.destination = to;
  one.header.incarnation = incarnation;
  return one;
}

const Link& only(const std::vector<Link>& links) {
  EXPECT_EQ(links.size(), 1U);
  return links.front();
}

TEST(Links, AreOfHeartbeatsWithTheTimeBetweenThem) {
  Links links;
  links.hear(heartbeat(10, 1), at(1));
  links.hear(heartbeat(10, 1), at(1.5));
  ASSERT_EQ(links.all().size(), 2U);
  const Link link = links.all().back();
  EXPECT_EQ(link.from, 10U);
  EXPECT_EQ(link.to, 1U);
  EXPECT_EQ(link.heartbeat, at(1.5));
  EXPECT_DOUBLE_EQ(*link.period, 0.5);
  EXPECT_FALSE(link.heard.has_value()) << "a heartbeat on the wire is not yet one that was heard";
}

TEST(Links, AreHeardAsTheReceiversHeartbeatsSay) {
  Links links;
  wire::Heartbeat back = heartbeat(1, 10);
  links.hear(back, at(1));
  EXPECT_EQ(links.all().back().from, 10U);
  EXPECT_EQ(links.all().back().heard, false) << "10 is silent for 1";
  back.ack_incarnation = 7;
  links.hear(back, at(2));
  EXPECT_EQ(links.all().back().heard, true);
}

TEST(Links, CountEventsThatTheReceiverHasNotAcknowledged) {
  Links links;
  wire::Heartbeat there = heartbeat(10, 1, 7);
  there.events_to = 12;
  links.hear(there, at(1));
  EXPECT_FALSE(links.all().back().waiting.has_value());
  wire::Heartbeat back = heartbeat(1, 10);
  back.ack_incarnation = 7;
  back.ack_sequence = 9;
  links.hear(back, at(1));
  EXPECT_EQ(links.all()[1].waiting, 3U);
}

TEST(Links, AnAcknowledgementOfAFormerLifeCountsForNothing) {
  Links links;
  wire::Heartbeat back = heartbeat(1, 10);
  back.ack_incarnation = 6;
  links.hear(back, at(1));
  links.hear(heartbeat(10, 1, 7), at(1));
  EXPECT_FALSE(links.all()[1].waiting.has_value());
}

TEST(Links, ASecondProcessOfOneNameLeavesThemAsTheyAre) {
  Links links;
  wire::Heartbeat first = heartbeat(10, 1, 7), second = heartbeat(10, 1, 50);
  first.events_to = 12;
  first.ack_incarnation = 1;
  wire::Heartbeat back = heartbeat(1, 10);
  back.ack_incarnation = 7;
  back.ack_sequence = 9;
  for (int i = 0; i < 5; ++i) {
    links.hear(first, at(i));
    links.hear(back, at(i + 0.1));
    links.hear(second, at(i + 0.5));
  }
  const std::vector<Link> all = links.all();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].waiting, 3U);
  EXPECT_DOUBLE_EQ(*all[1].period, 1.0);
  EXPECT_EQ(all[0].heard, true) << "the second hears nobody";
}

TEST(Links, AProcessThatWasStartedAgainIsTheNodeOnceOthersAcknowledgeIt) {
  Links links;
  wire::Heartbeat back = heartbeat(1, 10);
  for (const std::uint64_t life : {7, 8}) {
    wire::Heartbeat there = heartbeat(10, 1, life);
    there.events_to = life;
    back.ack_incarnation = life;
    links.hear(back, at(0.1));
    links.hear(there, at(0.2));
  }
  EXPECT_EQ(links.all()[1].waiting, 8U);
}

TEST(Links, AreNotOfHeartbeatsThatArePublished) {
  Links links;
  links.hear(heartbeat(10, 0), at(1));
  EXPECT_TRUE(links.all().empty());
}

TEST(Links, AreCarriedOrNotAsTheSimulatorSays) {
  Links links;
  wire::LinkState state;
  state.from = 10;
  state.to = 11;
  state.up = false;
  links.hear(state, at(1));
  EXPECT_EQ(only(links.all()).carried, false);
}

TEST(Links, AreHeardAsTheReceiverSaysInItsLog) {
  Links links;
  wire::DirectoryEntry marvin;
  marvin.header.origin = 10;
  marvin.name = "marvin";
  links.hear(marvin, at(1));
  wire::JournalEntry entry;
  entry.header.origin = 1;
  entry.record = R"({"at":3,"node":"ground","kind":"reach","peer":"marvin","reachable":true})";
  links.hear(entry, at(1));
  EXPECT_EQ(only(links.all()).heard, true);
  entry.record = R"({"at":4,"node":"ground","kind":"reach","peer":"marvin","reachable":false})";
  links.hear(entry, at(2));
  EXPECT_EQ(only(links.all()).heard, false);
}

TEST(Links, AreHeardAsTheGroundStationsBoardSays) {
  Links links;
  wire::DirectoryEntry marvin;
  marvin.header.origin = 10;
  marvin.name = "marvin";
  wire::UavBoard board;
  board.header.origin = 1;
  board.uav = "marvin";
  board.reachable = true;
  links.hear(board, at(1));
  EXPECT_TRUE(links.all().empty()) << "nobody knows yet who marvin is";
  links.hear(marvin, at(1));
  links.hear(board, at(1));
  EXPECT_EQ(only(links.all()).heard, true);
}

TEST(Links, PassOverRecordsThatAreNone) {
  Links links;
  wire::JournalEntry entry;
  for (const char* text : {"", "{", R"({"at":3,"node":"ground","kind":"reach"})", "[1]"}) {
    entry.record = text;
    links.hear(entry, at(1));
  }
  EXPECT_TRUE(links.all().empty());
}

}  // namespace
}  // namespace skein::spy_tool
