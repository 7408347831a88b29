// SPDX-License-Identifier: Apache-2.0
#include "graph.hpp"

#include <gtest/gtest.h>

#include "listener.hpp"
#include "silence.hpp"

namespace skein::spy_tool {
namespace {

Duration at(double seconds) { return Duration::seconds(seconds); }

blackboard::ParticipantSeen participant(const std::string& guid, const std::string& name) {
  blackboard::Participant one;
  one.guid = guid;
  one.name = name;
  return {one, false};
}

blackboard::EndpointSeen writer(const std::string& participant, wire::Slot slot) {
  blackboard::Endpoint one = reader_of(slot, {"world"});
  one.writer = true;
  one.participant = participant;
  one.guid = participant + ".1";
  return {one, false};
}

wire::DirectoryEntry entry(std::uint32_t number, const std::string& name) {
  wire::DirectoryEntry one;
  one.header.origin = number;
  one.name = name;
  return one;
}

TEST(Graph, CallsAParticipantByItsNodeElseByItsOwnNameElseByItsGuid) {
  Graph graph;
  graph.see(participant("aa", ""), at(1));
  EXPECT_EQ(graph.owner_of("aa"), "aa");
  graph.see(participant("aa", "tool"), at(1));
  EXPECT_EQ(graph.owner_of("aa"), "tool");
  const auto ground = entry(1, "ground");
  graph.hear("aa.1", at(2), 1, &ground);
  EXPECT_EQ(graph.owner_of("aa"), "ground");
  EXPECT_EQ(graph.name_of(1), "ground");
  EXPECT_EQ(graph.name_of(7), "node 7");
}

TEST(Graph, CallsANodeByWhoSpokeForItUntilThatIsKnownToBeAnother) {
  Graph graph;
  graph.see(participant("aa", "marvin"), at(1));
  graph.hear("aa.1", at(2), 10, nullptr);
  graph.hear("aa.1", at(2), 11, nullptr);  // passed on for another
  EXPECT_EQ(graph.name_of(10), "marvin");

  const auto marvin = entry(10, "marvin");
  graph.hear("aa.2", at(3), 10, &marvin);

  EXPECT_EQ(graph.name_of(10), "marvin");
  EXPECT_EQ(graph.name_of(11), "node 11");
}

TEST(Graph, ForgetsTheEndpointsOfWhoLeavesButNotTheName) {
  Graph graph;
  graph.see(participant("aa", "tool"), at(1));
  graph.see(writer("aa", wire::Slot::kClock), at(1));
  EXPECT_EQ(graph.of_topic("Clock", true).size(), 1U);
  EXPECT_TRUE(graph.of_topic("Clock", false).empty());
  graph.see(blackboard::ParticipantGone{"aa", false}, at(3));
  EXPECT_TRUE(graph.endpoints().empty());
  EXPECT_EQ(graph.owner_of("aa"), "tool");
}

TEST(Graph, KnowsSinceWhenAndTheLastSample) {
  Graph graph;
  graph.see(participant("aa", "tool"), at(1));
  graph.see(participant("aa", "tool"), at(4));
  graph.hear("aa.9", at(5), 0, nullptr);
  EXPECT_EQ(graph.participants().at("aa").since, at(1));
  EXPECT_EQ(graph.participants().at("aa").heard, at(5));
  graph.hear("bb.9", at(5), 0, nullptr);  // a stranger
  EXPECT_EQ(graph.participants().size(), 1U);
}

TEST(Graph, AnEndpointThatComesBackIsFoundAnew) {
  Graph graph;
  graph.see(writer("aa", wire::Slot::kClock), at(1));
  graph.see(writer("aa", wire::Slot::kClock), at(2));
  EXPECT_EQ(graph.found("aa.1"), at(1));
  graph.see(blackboard::EndpointGone{"aa.1"}, at(3));
  EXPECT_FALSE(graph.found("aa.1").has_value());
  graph.see(writer("aa", wire::Slot::kClock), at(4));
  EXPECT_EQ(graph.found("aa.1"), at(4));
}

TEST(SlotOf, IsOfATopicOfOursWithItsType) {
  EXPECT_EQ(slot_of(reader_of(wire::Slot::kClock, {})), wire::Slot::kClock);
  blackboard::Endpoint other = reader_of(wire::Slot::kClock, {});
  other.type = "rosgraph::Clock";
  EXPECT_FALSE(slot_of(other).has_value());
  other.topic = "clock";
  EXPECT_FALSE(slot_of(other).has_value());
}

TEST(Silence, OfANodeThatNobodyIsSaysSoWithTheNearest) {
  Graph graph;
  graph.see(participant("aa", "marvin"), at(1));
  graph.see(writer("aa", wire::Slot::kClock), at(1));
  SpyOptions options;
  options.slots = {"Clock"};
  options.partitions = {"world"};
  EXPECT_EQ(silence_of(options, graph, 0).why.find("nobody there"), std::string::npos);
  for (const char* known : {"marvin", "10"}) {
    options.from = known;
    EXPECT_EQ(silence_of(options, graph, 3).why.find("nobody there"), std::string::npos) << known;
  }

  options.from = "marwin";
  EXPECT_EQ(silence_of(options, graph, 3).why,
            "3 samples came, none as asked for; nobody there is called 'marwin'; did you mean "
            "'marvin'?");
  EXPECT_NE(silence_of(options, graph, 0).why.find("did you mean 'marvin'?"), std::string::npos);
}

}  // namespace
}  // namespace skein::spy_tool
