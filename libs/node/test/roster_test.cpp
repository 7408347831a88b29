// SPDX-License-Identifier: Apache-2.0
#include "skein/node/roster.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace skein::node {
namespace {

using blackboard::ChannelConfig;
using blackboard::ChannelKind;

std::vector<ChannelConfig> of_kind(const std::vector<ChannelConfig>& channels, ChannelKind kind) {
  std::vector<ChannelConfig> found;
  std::copy_if(channels.begin(), channels.end(), std::back_inserter(found),
               [&](const ChannelConfig& channel) { return channel.kind == kind; });
  return found;
}

TEST(Roster, NumbersFollowFromTheScenarioAlone) {
  const Roster roster({"marvin", "heliv"});

  EXPECT_EQ(roster.ground(), NodeNumber(1));
  EXPECT_EQ(roster.sim(), NodeNumber(2));
  EXPECT_EQ(roster.runner(), NodeNumber(3));
  EXPECT_EQ(roster.operators(), NodeNumber(4));
  EXPECT_EQ(roster.find("marvin")->number, NodeNumber(10));
  EXPECT_EQ(roster.find("heliv")->number, NodeNumber(11));
  EXPECT_EQ(roster.find("heliv")->role, wire::Role::kDdn);
  EXPECT_EQ(roster.find(NodeNumber(10))->name, "marvin");
}

TEST(Roster, StrangersHaveNoPlaceButAPrintableName) {
  const Roster roster({"marvin"});

  EXPECT_EQ(roster.find("heliv"), nullptr);
  EXPECT_EQ(roster.find(NodeNumber(11)), nullptr);
  EXPECT_EQ(roster.name_of(NodeNumber(10)), "marvin");
  EXPECT_EQ(roster.name_of(NodeNumber(11)), "node 11");
}

TEST(Roster, TheGroundTalksOverRadioWithEveryUavAndOnlyWithThem) {
  const Roster roster({"marvin", "heliv"});

  const auto channels = roster.channels_of(*roster.find("ground"));

  ASSERT_EQ(channels.size(), 5U);
  EXPECT_EQ(channels[0].kind, ChannelKind::kWorld);
  EXPECT_EQ(of_kind(channels, ChannelKind::kRadio).size(), 4U);
  EXPECT_EQ(channels[1].partition, "radio/ground>marvin");
  EXPECT_EQ(channels[2].partition, "radio/marvin>ground");
}

TEST(Roster, AUavTalksWithItsOwnVehicleOnly) {
  const Roster roster({"marvin", "heliv"});

  const auto onboard = of_kind(roster.channels_of(*roster.find("marvin")), ChannelKind::kOnboard);

  ASSERT_EQ(onboard.size(), 2U);
  for (const ChannelConfig& channel : onboard) EXPECT_EQ(channel.partition, "onboard/marvin");
}

TEST(Roster, TheSimulatorHasNoRadioAndTheRunnerOnlyTheWorld) {
  const Roster roster({"marvin", "heliv"});

  const auto sim = roster.channels_of(*roster.find("sim"));
  const auto runner = roster.channels_of(*roster.find("runner"));

  EXPECT_EQ(of_kind(sim, ChannelKind::kRadio).size(), 0U);
  EXPECT_EQ(of_kind(sim, ChannelKind::kOnboard).size(), 4U);
  ASSERT_EQ(runner.size(), 1U);
  EXPECT_EQ(runner[0].kind, ChannelKind::kWorld);
}

TEST(Roster, AUavMayHaveAFunctionalLayerOfItsOwn) {
  const Roster roster({"marvin", "heliv", "karma"},
                      {{"heliv", "autopilot"}, {"karma", "autopilot"}});

  const Member autopilot = *roster.find("autopilot");
  EXPECT_EQ(autopilot.role, wire::Role::kFunctional);
  EXPECT_EQ(autopilot.number, NodeNumber(500));
  EXPECT_EQ(roster.functional_of(roster.find("marvin")->number), roster.sim());
  EXPECT_EQ(roster.functional_of(roster.find("heliv")->number), autopilot.number);
  EXPECT_EQ(of_kind(roster.channels_of(autopilot), ChannelKind::kOnboard).size(), 4U);
  EXPECT_EQ(of_kind(roster.channels_of(autopilot), ChannelKind::kRadio).size(), 0U);
  EXPECT_EQ(of_kind(roster.channels_of(*roster.find("sim")), ChannelKind::kOnboard).size(), 2U);
  for (const ChannelConfig& one :
       of_kind(roster.channels_of(*roster.find("heliv")), ChannelKind::kOnboard)) {
    EXPECT_TRUE(one.from == autopilot.number || one.to == autopilot.number);
  }
}

TEST(Roster, OfSomeMembersOnlyKeepsTheirNumbersAndTheirChannels) {
  const Roster whole({"marvin", "heliv"}, {{"heliv", "autopilot"}});

  const Roster pair = whole.only({"heliv", "autopilot"});

  EXPECT_EQ(pair.members().size(), 2U);
  EXPECT_EQ(pair.find("heliv")->number, whole.find("heliv")->number);
  EXPECT_EQ(pair.functional_of(pair.find("heliv")->number), pair.find("autopilot")->number);
  const auto channels = pair.channels_of(*pair.find("heliv"));
  EXPECT_EQ(of_kind(channels, ChannelKind::kRadio).size(), 0U);
  EXPECT_EQ(of_kind(channels, ChannelKind::kOnboard).size(), 2U);
}

TEST(Roster, NobodyButTheRunnerReadsTheEventLog) {
  for (const auto role :
       {wire::Role::kGround, wire::Role::kDdn, wire::Role::kSim, wire::Role::kFunctional}) {
    const auto reads = Roster({"marvin"}).world_reads_of(role);
    EXPECT_EQ(std::count(reads.begin(), reads.end(), wire::Slot::kJournalEntry), 0)
        << name_of(role);
  }
  const auto reads = Roster({"marvin"}).world_reads_of(wire::Role::kRunner);
  EXPECT_EQ(std::count(reads.begin(), reads.end(), wire::Slot::kJournalEntry), 1);
}

// By them it knows which of two processes with one name is the node; peers know it by others.
TEST(Roster, WhoHearsNodesOverTheWorldChannelOnlyReadsTheirHeartbeatsThere) {
  const Roster roster({"marvin"});
  const auto reads_heartbeats = [&](wire::Role role) {
    const auto reads = roster.world_reads_of(role);
    return std::count(reads.begin(), reads.end(), wire::Slot::kHeartbeat) > 0;
  };
  for (const auto role : {wire::Role::kRunner, wire::Role::kOperator, wire::Role::kGround,
                          wire::Role::kSim, wire::Role::kFunctional})
    EXPECT_TRUE(reads_heartbeats(role)) << name_of(role);
  EXPECT_FALSE(reads_heartbeats(wire::Role::kDdn));
  for (const char* name : {"ground", "sim", "marvin"})
    EXPECT_TRUE(roster.channels_of(*roster.find(name)).front().carries(wire::Slot::kHeartbeat))
        << name;
}

TEST(Roster, ATableOfItsOwnDecidesWhatChannelsCarry) {
  auto table = blackboard::read_slot_table(
      "slots: {Alarm: {flows: [uav>ground]}, Truth: {flows: [sim>world]}}", "mine.yaml",
      blackboard::SlotTable::shipped());
  ASSERT_TRUE(table.has_value());
  const Roster roster = Roster({"marvin", "heliv"}).with_slots(std::move(*table));

  for (const ChannelConfig& channel : roster.channels_of(*roster.find("marvin"))) {
    if (channel.kind != ChannelKind::kRadio) continue;
    EXPECT_EQ(channel.carries(wire::Slot::kAlarm), channel.to == roster.ground())
        << channel.partition;
  }
  const auto reads = roster.world_reads_of(wire::Role::kRunner);
  EXPECT_EQ(std::count(reads.begin(), reads.end(), wire::Slot::kTruth), 0);
  EXPECT_EQ(&Roster({"marvin"}).slots(), &blackboard::SlotTable::shipped());
}

TEST(Roster, WhoeverHasARadioIsToldOfTheLinks) {
  for (const auto role : {wire::Role::kGround, wire::Role::kDdn}) {
    const auto reads = Roster({"marvin"}).world_reads_of(role);
    EXPECT_EQ(std::count(reads.begin(), reads.end(), wire::Slot::kLinkState), 1) << name_of(role);
  }
}

// Missions and changes of degree come from the ground station, and what a UAV says of its plans
// goes there, and nowhere else.
TEST(Roster, OnlyTheStationCommandsAndIsTold) {
  const Roster roster({"marvin", "heliv"});
  const auto carried = [&](std::string_view from, std::string_view to, wire::Slot slot) {
    for (const ChannelConfig& channel : roster.channels_of(*roster.find(from))) {
      if (channel.from != roster.find(from)->number) continue;
      if (channel.to != roster.find(to)->number) continue;
      return std::count(channel.slots.begin(), channel.slots.end(), slot) == 1;
    }
    return false;
  };

  for (const auto slot :
       {wire::Slot::kMissionRequest, wire::Slot::kDegreeCommand, wire::Slot::kWorldChange}) {
    EXPECT_TRUE(carried("ground", "marvin", slot)) << wire::slot_name(slot);
    EXPECT_FALSE(carried("marvin", "ground", slot)) << wire::slot_name(slot);
    EXPECT_FALSE(carried("heliv", "marvin", slot)) << wire::slot_name(slot);
  }
  for (const auto slot : {wire::Slot::kMissionPlan, wire::Slot::kMissionOutcome,
                          wire::Slot::kHandOver, wire::Slot::kDecision}) {
    EXPECT_TRUE(carried("marvin", "ground", slot)) << wire::slot_name(slot);
    EXPECT_FALSE(carried("ground", "marvin", slot)) << wire::slot_name(slot);
    EXPECT_FALSE(carried("marvin", "heliv", slot)) << wire::slot_name(slot);
  }
}

const ChannelConfig& channel_between(const std::vector<ChannelConfig>& channels, NodeNumber from,
                                     NodeNumber to) {
  return *std::find_if(channels.begin(), channels.end(), [&](const ChannelConfig& channel) {
    return channel.from == from && channel.to == to;
  });
}

// What a relay passes on for the station it must not say itself.
TEST(Roster, ARelayHasChannelsForOrdersAndAnswersButNoSayOfItsOwn) {
  const Roster roster = Roster({"near", "far"}).relayed_by({"near"});
  const Member& near = *roster.find("near");
  const Member& far = *roster.find("far");
  const auto channels = roster.channels_of(near);
  const ChannelConfig& to_far = channel_between(channels, near.number, far.number);
  const ChannelConfig& from_far = channel_between(channels, far.number, near.number);
  const ChannelConfig& to_ground = channel_between(channels, near.number, roster.ground());

  EXPECT_TRUE(to_far.relays(wire::Slot::kMissionRequest));
  EXPECT_FALSE(to_far.originates(wire::Slot::kMissionRequest));
  EXPECT_FALSE(to_far.carries(wire::Slot::kMissionPlan));
  EXPECT_TRUE(from_far.carries(wire::Slot::kMissionPlan));
  EXPECT_FALSE(from_far.originates(wire::Slot::kMissionPlan));
  EXPECT_FALSE(from_far.relays(wire::Slot::kTelemetry));
  EXPECT_TRUE(to_ground.relays(wire::Slot::kMissionPlan));
  EXPECT_TRUE(to_ground.originates(wire::Slot::kMissionPlan));
  EXPECT_FALSE(to_ground.carries(wire::Slot::kTaskRequest));
}

TEST(Roster, WithoutRelaysNobodyTellsWhomItHears) {
  const Roster roster({"near", "far"});
  for (const ChannelConfig& channel : roster.channels_of(*roster.find("near"))) {
    EXPECT_FALSE(channel.carries(wire::Slot::kNeighbours)) << channel.partition;
    EXPECT_TRUE(channel.relayed.empty()) << channel.partition;
  }
}

// Every channel but the world is known, with the same partition and slots, to exactly the two
// nodes at its ends; and numbers and names are distinct.
RC_GTEST_PROP(Roster, BothEndsOfAChannelAgreeOnIt, ()) {
  const int count = *rc::gen::inRange(0, 8);
  std::vector<std::string> uavs;
  for (int i = 0; i < count; ++i) uavs.push_back("uav-" + std::to_string(i));
  const Roster roster = Roster(uavs).relayed_by(*rc::gen::container<std::vector<std::string>>(
      rc::gen::elementOf(std::vector<std::string>{"ground", "uav-0", "uav-1", "uav-5"})));
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::string, std::vector<wire::Slot>>;
  std::map<Key, std::set<std::string>> known;
  std::set<NodeNumber> numbers;

  for (const Member& member : roster.members()) {
    numbers.insert(member.number);
    for (const ChannelConfig& channel : roster.channels_of(member)) {
      if (channel.kind == ChannelKind::kWorld) continue;
      const auto inserted =
          known[{channel.from.value(), channel.to.value(), channel.partition, channel.slots}]
              .insert(member.name);
      RC_ASSERT(inserted.second);
    }
  }

  RC_ASSERT(numbers.size() == roster.members().size());
  for (const auto& [key, members] : known) {
    const std::set<std::string> ends{roster.name_of(NodeNumber(std::get<0>(key))),
                                     roster.name_of(NodeNumber(std::get<1>(key)))};
    RC_ASSERT(ends == members);
  }
  const auto n = static_cast<std::size_t>(count);
  RC_ASSERT(known.size() == n * (n + 1) + 2 * n);  // radio among n + 1, onboard of n
}

}  // namespace
}  // namespace skein::node
