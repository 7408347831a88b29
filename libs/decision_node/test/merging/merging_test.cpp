// SPDX-License-Identifier: Apache-2.0
// No motion goes to the vehicle before it has its air.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "skein/supervisor/own_ways.hpp"
#include "testing/merged_team.hpp"

namespace skein::decision_node {
namespace {

using executive::TaskState;
using testing::before_a_wall;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::give_sweep;
using testing::goto_of;
using ::testing::IsEmpty;
using testing::last_had;
using testing::MergedTeam;
using ::testing::SizeIs;
using testing::takeoff_of;

std::vector<std::string> states(const std::vector<AirNoted>& notes) {
  std::vector<std::string> result;
  for (const AirNoted& one : notes) result.push_back(one.state);
  return result;
}

// Along y = 0, one from each side, at one height.
MergedTeam opposite() { return MergedTeam({{"marvin", {-100, 0, 40}}, {"heliv", {100, 0, 40}}}); }

TEST(Merging, AWayThroughFreeAirIsFlownAtOnce) {
  MergedTeam team = opposite();
  team.command("heliv", goto_of(7, {100, 200, 40}));
  team.run(1);
  EXPECT_THAT(team.begun("heliv"), ElementsAre(7U));
  EXPECT_EQ(last_had(team.notes("heliv")).raised, 0);
}

TEST(Merging, WhoStaysInTheWayIsFlownOver) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}});
  team.command("heliv", goto_of(7, {-100, 0, 40}));
  team.run(60);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_EQ(last_had(team.notes("heliv")).raised, 12);
  EXPECT_NEAR(team.highest("heliv"), 52, 0.5);
  EXPECT_NEAR(team.state("heliv").position.z(), 40, 0.5);
}

TEST(Merging, AWayThatSomethingIsLookedAtAlongIsNotRaised) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}});
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
  team.run(30);
  EXPECT_THAT(team.begun("heliv"), IsEmpty());
  const auto notes = team.notes("heliv");
  ASSERT_FALSE(notes.empty());
  EXPECT_THAT(notes.back().waits_for, ElementsAre("marvin to leave"));

  team.command("marvin", goto_of(3, {0, 200, 40}));
  team.run(60);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_NEAR(team.highest("heliv"), 40, 0.5);
}

TEST(Merging, WhoStaysInTheWayForLongIsFlownAround) {
  MergedTeam team = before_a_wall();
  team.command("heliv", goto_of(7, {-100, 0, 40}));
  team.run(10);
  EXPECT_THAT(team.begun("heliv"), IsEmpty());
  team.run(60);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_GE(last_had(team.notes("heliv")).waited, Duration::seconds(15));
  EXPECT_NEAR((team.state("heliv").position - world::Vector3(-100, 0, 40)).norm(), 0, 0.5);
}

TEST(Merging, AWayThatSomethingIsLookedAtAlongLeadsAroundNobody) {
  MergedTeam team = before_a_wall();
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
  team.run(100);
  EXPECT_THAT(team.begun("heliv"), IsEmpty());
}

TEST(Merging, WhoStaysWhereOneIsToGoIsWaitedFor) {
  MergedTeam team = before_a_wall();
  team.command("heliv", goto_of(7, {0, 0, 40}));
  team.run(100);
  EXPECT_THAT(team.begun("heliv"), IsEmpty());
}

constexpr double kJustHome = 0.115;  ///< at home; of the reserve of 10 % and a margin of 2 %
constexpr double kJustDown = 0.105;  ///< likewise, with half of the margin

TEST(Merging, WhoseEnergyLastsNoLongerThanToComeHomeGivesUpItsGoalAndDoesNotFlyThereUnasked) {
  MergedTeam team = before_a_wall();
  team.command("heliv", goto_of(7, {0, 0, 40}));
  team.run(100);
  ASSERT_FALSE(team.is_over("heliv", 7));
  team.drain("heliv", kJustHome);
  team.run(1);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_THAT(team.begun("heliv"), IsEmpty());
  EXPECT_EQ(team.events("heliv").back().cause, executive::AbortCause::kNoAir);
}

TEST(Merging, WhoseEnergyLastsNoLongerThanToComeHomeLandsUnasked) {
  MergedTeam team({{"marvin", {100, 0, 15}}, {"heliv", {100, 0, 60}}}, 4);
  team.cut("heliv", "marvin");
  team.command("heliv", testing::start_of(7, "land"));
  team.run(100);
  ASSERT_THAT(team.begun("heliv"), IsEmpty());
  team.drain("heliv", kJustHome);
  team.run(1);
  ASSERT_THAT(team.begun("heliv"), IsEmpty()) << "it has only to come down";
  team.drain("heliv", kJustDown);
  team.run(1);
  EXPECT_THAT(team.begun("heliv"), ElementsAre(7));
  EXPECT_THAT(states(team.notes("heliv")), ::testing::Contains("unasked"));
}

// The time-out of the executive is 120 s.
TEST(Merging, AMotionThatWaitsIsNotRunningAndItsExecutiveIsPatient) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}});
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
  team.run(400);
  std::vector<TaskState> seen;
  for (const auto& event : team.events("heliv"))
    if (event.id.value() == 7) seen.push_back(event.state);
  EXPECT_THAT(seen, ElementsAre(TaskState::kScheduled, TaskState::kStarted));
}

TEST(Merging, WhatWaitsIsInterruptedBeforeItBegins) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}});
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
  team.run(5);
  team.command("heliv", executive::Abort{executive::TaskId(7)});
  team.command("marvin", goto_of(3, {0, 200, 40}));
  team.run(60);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_THAT(team.begun("heliv"), IsEmpty());
}

// The later in the roster moves aside; both come to where they were sent.
// The ground station takes over what waits: it asks for it under the same id.
TEST(Merging, WhatIsAskedForOnceMoreWhileItWaitsGoesOnWaiting) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {0, 0, 0}}}, 1);
  const functional::Parameters climb = takeoff_of(7, 40).task.parameters;
  team.dispatch("heliv", 7, "takeoff", climb);
  team.run(5);
  team.dispatch("heliv", 7, "takeoff", climb);
  team.run(5);
  for (const functional::Status& status : team.passed_on("heliv"))
    EXPECT_EQ(status.state, functional::TaskState::kStarted) << status.reason;
  EXPECT_THAT(team.passed_on("heliv"), SizeIs(1));

  team.dispatch("marvin", 3, "goto", goto_of(3, {0, 200, 40}).task.parameters);
  team.run(60);
  EXPECT_THAT(team.begun("heliv"), ElementsAre(7U));
}

TEST(Merging, WhatIsAskedForOnceMoreWhileItIsFlownIsTheVehiclesToAnswer) {
  MergedTeam team({{"marvin", {0, 300, 40}}, {"heliv", {0, 0, 40}}}, 1);
  const functional::Parameters way = goto_of(7, {100, 0, 40}).task.parameters;
  team.dispatch("heliv", 7, "goto", way);
  team.run(3);
  team.dispatch("heliv", 7, "goto", way);
  team.run(60);
  EXPECT_THAT(team.begun("heliv"), ElementsAre(7U, 7U));
  EXPECT_EQ(team.passed_on("heliv").back().state, functional::TaskState::kEnded);
}

TEST(Merging, TwoThatAreToChangePlacesDoSo) {
  MergedTeam team = opposite();
  give_sweep(team, "marvin", goto_of(7, {100, 0, 40}));
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
  team.run(150);
  EXPECT_TRUE(team.is_over("marvin", 7));
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_THAT(states(team.notes("heliv")), Contains("aside"));
  EXPECT_NEAR((team.state("heliv").position - world::Vector3(-100, 0, 40)).norm(), 0, 0.5);
}

/// All places up, and beside at the height of the first, that one there could get out of the way
/// to.
void look_all_round(std::vector<double>& waypoints, double x, double y, double z) {
  const auto to = [&](double east, double north, double up) {
    waypoints.insert(waypoints.end(), {x + east, y + north, z + up});
  };
  to(0, 0, 0);
  to(0, 0, 70);
  to(0, 0, 0);
  for (int i = 0; i < 8; ++i) {
    const double angle = 0.25 * i * std::numbers::pi;
    to(300 * std::cos(angle), 300 * std::sin(angle), 0);
    to(0, 0, 0);
  }
}

// Found by random missions (--hands 682): it had landed meanwhile, and asked to be woken at that
// instant for ever.
TEST(Merging, WhoCannotFlyAnyMoreWhatItGetsOutOfTheWayForRefusesIt) {
  int refused = 0;
  for (int tenths = 0; tenths < 60; ++tenths) {
    MergedTeam team({{"marvin", {-100, 0, 40}}, {"heliv", {100, 0, 40}}});
    give_sweep(team, "marvin", goto_of(7, {100, 0, 40}));
    give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
    team.tell_every(1 + tenths);
    team.run(0.1 * (tenths % 10));
    team.put_down("heliv");
    team.run(20);
    EXPECT_THAT(team.restless(), IsEmpty()) << tenths;
    for (const executive::TaskEvent& event : team.events("heliv"))
      refused += event.reason == "goto before takeoff: the vehicle is on the ground" ? 1 : 0;
  }
  EXPECT_GT(refused, 0);
}

// Found by random missions (--crossing 41821, 31365): 27 s.
TEST(Merging, WhoFindsNoPlaceThatNobodyWantsMovesWhereTheCircleDoesNotWantToGo) {
  MergedTeam team({{"karma", {0, 500, 15}}, {"marvin", {-100, 0, 15}}, {"heliv", {100, 0, 15}}});
  std::vector<double> everywhere;
  look_all_round(everywhere, -100, 0, 15);
  look_all_round(everywhere, 100, 0, 15);
  give_sweep(team, "karma", goto_of(7, everywhere));
  team.run(1);
  give_sweep(team, "marvin", goto_of(7, {100, 0, 15}));
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 15}));
  team.run(3);
  EXPECT_THAT(states(team.notes("heliv")), Contains("aside"));
  team.run(120);
  EXPECT_GT(team.highest("heliv"), 35)
      << "beside it there was no place at its height, or over it, or under";
  EXPECT_TRUE(team.is_over("marvin", 7) || team.is_over("karma", 7)) << "the circle is parted";
}

// Heliv is to land where marvin is to rise past it: it gets out of the way, and lands where it was
// sent to.
TEST(Merging, WhoGotOutOfTheWayComesBackToLand) {
  MergedTeam team({{"marvin", {0, 0, 20}}, {"heliv", {0, 0, 60}}});
  give_sweep(team, "marvin", goto_of(7, {0, 0, 110}));
  team.command("heliv", testing::start_of(7, "land"));
  team.run(150);
  EXPECT_TRUE(team.is_over("marvin", 7));
  ASSERT_TRUE(team.is_over("heliv", 7));
  EXPECT_THAT(states(team.notes("heliv")), ::testing::IsSupersetOf({"aside", "back", "had"}));
  EXPECT_NEAR(team.state("heliv").position.norm(), 0, 0.5);
}

TEST(Merging, WhatWaitedAndIsGivenUpIsSaidToBe) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}});
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
  team.run(5);
  team.command("heliv", executive::Abort{executive::TaskId(7)});
  EXPECT_THAT(states(team.notes("heliv")), ElementsAre("waits", "given-up"));
}

TEST(Merging, AFlightOfARoleThatTheGroundPlaysIsGivenUpForWantOfAirAfterFourMinutes) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}});
  const executive::TaskId flight = functional::kFirstPlayedId;
  give_sweep(team, "heliv", goto_of(flight.value(), {-100, 0, 40}));
  team.run(239);
  EXPECT_FALSE(team.is_over("heliv", flight.value()));

  team.run(2);

  std::vector<executive::TaskEvent> aborted;
  for (const executive::TaskEvent& event : team.events("heliv")) {
    if (event.id == flight && event.state == TaskState::kAborted) aborted.push_back(event);
  }
  ASSERT_THAT(aborted, SizeIs(1));
  EXPECT_EQ(aborted.front().cause, executive::AbortCause::kNoAir) << aborted.front().reason;
}

// Found by random missions (--hands 169): the plan waited behind it for ever.
TEST(Merging, WhatAnOperatorAskedForOfOneThatPlansIsGivenUpForWantOfAirAfterSixMinutes) {
  MergedTeam team = before_a_wall();
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
  team.run(359);
  EXPECT_FALSE(team.is_over("heliv", 7));
  team.run(3);
  ASSERT_TRUE(team.is_over("heliv", 7));
  EXPECT_THAT(team.begun("heliv"), IsEmpty());
}

// Marvin may wait for heliv, at a meeting: it has nothing else to do, and makes room.
TEST(Merging, WhoDeliberatesAndHasNothingToDoMakesRoom) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}}, 4);
  give_sweep(team, "heliv", goto_of(7, {0, 0, 40}));
  team.run(40);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_THAT(states(team.notes("marvin")), ElementsAre("aside"));
}

// Found by random missions (--meetings --orders 20021, 20150): it waited in safe mode, for ever.
TEST(Merging, WhoWaitsForWantOfAnythingElseMakesRoom) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}}, 4);
  team.command("marvin", testing::start_of(9, "wait"));
  team.run(1);
  give_sweep(team, "heliv", goto_of(7, {0, 0, 40}));
  team.run(40);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_TRUE(team.is_over("marvin", 9));
  EXPECT_THAT(states(team.notes("marvin")), ElementsAre("aside"));
}

TEST(Merging, WhereItsOperatorPutItAUavStays) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}}, 3);
  give_sweep(team, "heliv", goto_of(7, {0, 0, 40}));
  team.run(40);
  EXPECT_FALSE(team.is_over("heliv", 7));
  EXPECT_THAT(team.notes("marvin"), IsEmpty());
}

// Heliv flies aside when it is to hold instead.
TEST(Merging, WhoIsToHoldWhileItFliesAsideHoldsOnceItIsThere) {
  MergedTeam team = opposite();
  give_sweep(team, "marvin", goto_of(7, {100, 0, 40}));
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
  for (int i = 0; i < 100 && states(team.notes("heliv")).back() != "aside"; ++i) team.run(0.1);
  ASSERT_EQ(states(team.notes("heliv")).back(), "aside");

  team.command("heliv", executive::Abort{executive::TaskId(7)});
  team.command("heliv", testing::start_of(9, "wait"));
  EXPECT_THAT(team.begun("heliv"), SizeIs(1)) << "it still moves";
  team.run(60);
  ASSERT_THAT(team.begun("heliv"), SizeIs(2));
  EXPECT_EQ(team.begun("heliv").back(), 9U);
}

TEST(Merging, ATakeoffWaitsForWhoIsOverTheGround) {
  MergedTeam team({{"marvin", {0, 0, 30}}, {"heliv", {0, 5, 0}}});
  team.command("heliv", takeoff_of(7, 40));
  team.run(20);
  EXPECT_THAT(team.begun("heliv"), IsEmpty());
  team.command("marvin", goto_of(3, {200, 0, 30}));
  team.run(60);
  EXPECT_TRUE(team.is_over("heliv", 7));
}

// Found by random missions (--mixed 13): it waited for a third one that worked, so there was no
// circle.
TEST(Merging, WhoWaitsItselfOverAnothersPadGetsOutOfTheWay) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}, {"karma", {103, 0, 0}}});
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
  team.command("karma", takeoff_of(7, 60));
  team.run(8);
  EXPECT_THAT(team.begun("karma"), IsEmpty());
  team.run(60);
  EXPECT_TRUE(team.is_over("karma", 7));
  EXPECT_THAT(states(team.notes("heliv")), Contains("aside"));
}

TEST(Merging, WhoHasLandedLeavesItsAirToOthers) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}});
  team.command("marvin", testing::start_of(3, "land"));
  team.run(30);
  ASSERT_TRUE(team.is_over("marvin", 3));
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
  team.run(60);
  EXPECT_TRUE(team.is_over("heliv", 7));
}

// What it has is its own, whatever becomes of the radio; new air it is not given.
TEST(Merging, ACutLeavesWhoFliesItsWayAndKeepsTheLaterFromAnother) {
  MergedTeam team = opposite();
  team.command("heliv", goto_of(7, {100, 200, 40}));
  team.run(1);
  team.cut("marvin", "heliv");
  team.command("heliv", goto_of(9, {100, 0, 40}));
  team.command("marvin", goto_of(7, {-100, 200, 40}));
  team.run(90);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_THAT(team.begun("heliv"), ElementsAre(7U));
  EXPECT_TRUE(team.is_over("marvin", 7));
  EXPECT_THAT(team.notes("heliv").back().waits_for, ElementsAre("marvin to come into reach"));
}

// Its contact-loss policy is to return; home is under (0, 0, 50).
TEST(Merging, WhoIsOutOfReachOfAllFliesHomeThroughAirThatWasKeptForIt) {
  MergedTeam team({{"marvin", {0, 300, 40}}, {"heliv", {100, 0, 40}}}, 4, ContactPolicy::kReturn);
  team.command("heliv", goto_of(7, {100, 100, 40}));
  team.run(30);
  ASSERT_TRUE(team.is_over("heliv", 7));
  team.cut_from_all("heliv");
  team.run(60);
  EXPECT_NEAR(team.state("heliv").position.norm(), 0, 1);
}

TEST(Merging, WhileOneIsOutOfReachNobodyElseTakesItsAirHome) {
  MergedTeam team({{"marvin", {0, 300, 40}}, {"heliv", {200, 0, 40}}}, 4, ContactPolicy::kReturn);
  team.run(10);
  team.cut_from_all("heliv");
  team.command("marvin", goto_of(7, {100, 0, 45}));
  team.run(4);
  EXPECT_THAT(team.begun("marvin"), IsEmpty());
  team.run(60);
  EXPECT_NEAR(team.state("heliv").position.norm(), 0, 1);
}

// What is kept for it begins where its flight ends; stopped half-way it would hold there until its
// energy lasts no longer than to come home.
TEST(Merging, WhoCanAskNobodyHalfWayAlongAFlightFliesItToItsEndAndThenHome) {
  MergedTeam team({{"marvin", {0, 300, 40}}, {"heliv", {100, 0, 40}}}, 4, ContactPolicy::kReturn);
  team.command("heliv", goto_of(7, {100, 200, 40}));
  team.run(3);
  ASSERT_THAT(team.begun("heliv"), ElementsAre(7U));
  team.cut_from_all("heliv");
  team.run(6);
  ASSERT_FALSE(team.is_over("heliv", 7)) << "its policy is due half-way";
  team.run(90);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_NEAR(team.state("heliv").position.norm(), 0, 1);
}

TEST(Merging, WhoLosesContactOnceMoreOnItsWayHomeGoesOn) {
  MergedTeam team({{"marvin", {0, 300, 40}}, {"heliv", {200, 0, 40}}}, 4, ContactPolicy::kReturn);
  team.run(3);
  team.cut_from_all("heliv");
  team.run(10);
  team.heal_with_ground("heliv");
  team.run(1);
  team.cut_from_ground("heliv");
  team.run(120);
  EXPECT_NEAR(team.state("heliv").position.norm(), 0, 1);
  for (const executive::TaskEvent& one : team.events("heliv"))
    EXPECT_FALSE(one.type == "goto" && one.state == TaskState::kAborted) << one.reason;
}

TEST(Merging, AWayHomeFromHomeHasAnEnd) {
  const auto knowledge = testing::knowledge_of("heliv");
  const world::AirspaceGrid air{{-400, -400, 0}, 20, {40, 40, 12}};
  const world::Volume smoke{"smoke", {{100, 100}, {140, 100}, {140, 140}}, 0, 100, {}};
  const auto beside_smoke = std::make_shared<world::World>(
      world::World{{}, *MergedTeam::level_ground(), {}, air, {smoke}, {}, {}, {}, {}});
  const world::Vector3 home(0, 0, 50);
  EXPECT_GE(supervisor::own_way(knowledge, beside_smoke, {}, home, home).size(), 2U);
}

TEST(Merging, WhoCanAskTheOthersHalfWayComesHomeFromThere) {
  MergedTeam team({{"marvin", {0, 300, 40}}, {"heliv", {100, 0, 40}}}, 4, ContactPolicy::kReturn);
  team.command("heliv", goto_of(7, {100, 200, 40}));
  team.run(3);
  team.cut_from_ground("heliv");
  team.run(8);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_LT(team.state("heliv").position.y(), 190);
  team.run(90);
  EXPECT_NEAR(team.state("heliv").position.norm(), 0, 1);
}

TEST(Merging, WhatAnotherHasOfTheWayHomeIsNotFlownThrough) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {200, 0, 40}}}, 4, ContactPolicy::kReturn);
  team.run(10);
  team.cut_from_all("heliv");
  team.run(60);
  EXPECT_THAT(team.begun("heliv"), IsEmpty());
}

// Found by random missions (--hands 771): the vehicle waited, and refused to take off for it.
TEST(Merging, WhatHoldsTheVehicleIsRefusedWhileAMotionWaitsForItsAir) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {0, 0, 0}}}, 1);
  team.dispatch("heliv", 7, "takeoff", takeoff_of(7, 40).task.parameters);
  team.run(1);
  team.dispatch("heliv", 8, "wait", {});
  team.run(1);
  EXPECT_THAT(team.begun("heliv"), IsEmpty());
  EXPECT_EQ(team.passed_on("heliv").back().reason, "another motion waits for its air: takeoff");
}

TEST(Merging, WhatTheVehicleCannotDoIsRefusedWithItsReasons) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 0}}});
  team.command("heliv", goto_of(7, {-100, 0, 40}));
  team.run(6);
  ASSERT_TRUE(team.is_over("heliv", 7));
  EXPECT_EQ(team.events("heliv").back().reason,
            "goto before takeoff: the vehicle is on the ground");
}

}  // namespace
}  // namespace skein::decision_node
