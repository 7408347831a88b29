// SPDX-License-Identifier: Apache-2.0
// The table of slots: what ships, and what is wrong with others.
#include "skein/blackboard/slot_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "skein/blackboard/channel.hpp"

namespace skein::blackboard {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;
using wire::Slot;

std::vector<std::string> problems(const std::string& text) {
  const auto read = read_slot_table(text, "slots.yaml", SlotTable::shipped());
  std::vector<std::string> all;
  if (!read)
    for (const Diagnostic& one : read.error().all())
      all.push_back(std::to_string(one.line) + ": " + one.message + " (" + one.expected + ") " +
                    one.nearest);
  return all;
}

TEST(SlotTable, OrdersGoFromTheStationToUavsAndNowhereElse) {
  const SlotTable& table = SlotTable::shipped();
  EXPECT_THAT(table.between(Party::kGround, Party::kUav),
              IsSupersetOf({Slot::kTaskRequest, Slot::kMissionRequest, Slot::kDegreeCommand,
                            Slot::kWorldChange}));
  EXPECT_THAT(table.between(Party::kUav, Party::kUav), Not(Contains(Slot::kDegreeCommand)));
  EXPECT_THAT(table.between(Party::kUav, Party::kGround), Not(Contains(Slot::kDegreeCommand)));
}

TEST(SlotTable, OnlyTheSimulatorSaysWhichLinksThereAre) {
  const SlotTable& table = SlotTable::shipped();
  for (const Party party :
       {Party::kGround, Party::kUav, Party::kFunctional, Party::kOperator, Party::kOthers})
    EXPECT_THAT(table.between(party, Party::kWorld), Not(Contains(Slot::kLinkState)))
        << name_of(party);
  EXPECT_THAT(table.between(Party::kSim, Party::kWorld), Contains(Slot::kLinkState));
}

TEST(SlotTable, WhatGoesOverRadioIsPassedOnAndHasAShare) {
  const SlotTable& table = SlotTable::shipped();
  const std::vector<Slot> relayed = table.relayed();
  for (const auto& [from, to] :
       {std::pair(Party::kGround, Party::kUav), std::pair(Party::kUav, Party::kGround),
        std::pair(Party::kUav, Party::kUav)}) {
    for (const Slot slot : table.between(from, to)) {
      EXPECT_THAT(relayed, Contains(slot));
      EXPECT_GT(table.shares()[static_cast<std::size_t>(slot)].fraction, 0)
          << wire::slot_name(slot);
    }
  }
}

TEST(SlotTable, ARowOfAScenarioTakesThePlaceOfWhatItSays) {
  const auto read =
      read_slot_table("slots: {Telemetry: {share: 0.2}, Alarm: {flows: [uav>ground]}}", "mine.yaml",
                      SlotTable::shipped());
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->shares()[static_cast<std::size_t>(Slot::kTelemetry)].fraction, 0.2);
  EXPECT_THAT(read->between(Party::kUav, Party::kGround), Contains(Slot::kTelemetry));
  EXPECT_THAT(read->between(Party::kUav, Party::kUav), Not(Contains(Slot::kAlarm)));
  EXPECT_THAT(read->between(Party::kUav, Party::kGround), Contains(Slot::kAlarm));
}

TEST(SlotTable, ARowMaySayHowLongItsEventsCount) {
  const auto read =
      read_slot_table("slots: {SyncMessage: {lifespan: 12.5}}", "mine.yaml", SlotTable::shipped());
  ASSERT_TRUE(read.has_value());
  const auto sent = MissionTime::seconds(100);
  const auto expiry = [&](Slot slot, MissionTime wanted) {
    return expiry_of(slot, read->lifespans(), sent, wanted);
  };
  EXPECT_EQ(expiry(Slot::kSyncMessage, MissionTime::max()), MissionTime::seconds(112.5));
  EXPECT_EQ(expiry(Slot::kSyncMessage, MissionTime::seconds(101)), MissionTime::seconds(101));
  EXPECT_EQ(expiry(Slot::kTaskRequest, MissionTime::max()), MissionTime::max());
  EXPECT_EQ(expiry(Slot::kNegotiationMessage, MissionTime::max()), MissionTime::seconds(102))
      << "as in the table that ships";
}

TEST(SlotTable, WhatIsNoEventHasNoLifespan) {
  const auto all = problems(R"(slots:
  PlanBoard: {lifespan: 3}
  Telemetry: {lifespan: 3}
  Alarm: {lifespan: 0}
)");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_THAT(all[0], HasSubstr("2: only events have a lifespan, and PlanBoard is none"));
  EXPECT_THAT(all[1], HasSubstr("3: only events have a lifespan, and Telemetry is none"));
  EXPECT_THAT(all[2], HasSubstr("4: "));
}

TEST(SlotTable, AllThatIsWrongIsSaidAtOnceWithItsLineAndARemedy) {
  const auto all = problems(R"(slots:
  Telemetri: {share: 0.1}
  Alarm: {class: state}
  SyncMessage: {flows: [uav>grund, uav]}
  Truth: {relayed: true}
  Clock: {flows: [sim>uav], colour: red}
)");
  ASSERT_GE(all.size(), 7U);
  EXPECT_THAT(
      all, Contains(HasSubstr("2: no slot 'Telemetri' (the name of a struct of idl/) Telemetry")));
  EXPECT_THAT(all, Contains(HasSubstr("3: its class is another one (event, as its IDL says)")));
  EXPECT_THAT(all, Contains(HasSubstr("4: no node 'grund'")));
  EXPECT_THAT(all, Contains(HasSubstr("4: 'uav' is no flow (WHO>WHOM or WHO<>WHOM)")));
  EXPECT_THAT(all, Contains(HasSubstr("5: relays pass on what goes over radio")));
  EXPECT_THAT(all, Contains(HasSubstr("6: there is no channel sim>uav")));
  EXPECT_THAT(all, Contains(HasSubstr("colour")));
}

TEST(SlotTable, SharesThatAreMoreThanAChannelHasAreNamedWithTheGreatest) {
  const auto all = problems("slots: {Telemetry: {share: 0.9}}");
  EXPECT_THAT(all, Contains(HasSubstr("add up to")));
  EXPECT_THAT(all.front(), HasSubstr("most has Telemetry with 90 %"));
}

}  // namespace
}  // namespace skein::blackboard
