// SPDX-License-Identifier: Apache-2.0
// What the witness keeps free for one that it may lose is taken without asking, and nobody else has
// it then.
#include "skein/merging/standby.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "testing/exploration.hpp"

namespace skein::merging {
namespace {

using ::testing::ElementsAre;
using testing::Exploration;
using testing::kAnna;
using testing::kBert;
using testing::kGround;
using testing::street;
using testing::Trio;
using testing::two;

void hear_each_other_no_more(Trio& trio) {
  trio.give(kAnna, InReach{kBert, false});
  trio.give(kBert, InReach{kAnna, false});
}

TEST(Standby, WhoLosesContactWithAllTakesWhatWasKeptForIt) {
  for (const auto& [alone, other] : {std::pair(kAnna, kBert), std::pair(kBert, kAnna)}) {
    Trio trio = two();
    trio.give(alone, Need{{{street(0, 100), street(100, 200)}}});
    trio.run_for(1);
    trio.is_alone(alone);
    trio.give(alone, Want{{{street(0, 50)}}});
    EXPECT_EQ(trio.granted(alone), 1) << alone;
    trio.give(alone, Hold{{}});
    trio.give(alone, Want{{{street(110, 150)}}});
    EXPECT_EQ(trio.granted(alone), 2) << alone;
    trio.give(alone, Want{{{street(150, 250)}}});
    trio.run_for(10);
    EXPECT_EQ(trio.granted(alone), 2) << "that was never kept";
  }
}

TEST(Standby, NothingIsKeptThatTheWitnessDidNotSayItKeeps) {
  Trio trio = two();
  trio.give(kAnna, Need{{{street(0, 100)}}});
  trio.run_for(1, {kGround});
  trio.is_alone(kAnna);
  trio.give(kAnna, Want{{{street(0, 50)}}});
  EXPECT_EQ(trio.granted(kAnna), 0);
}

TEST(Standby, WhileItsOwnerIsOutOfReachNobodyElseHasIt) {
  Trio trio = two();
  trio.give(kAnna, Need{{{street(0, 100)}}});
  trio.run_for(5);
  trio.is_alone(kAnna);
  trio.give(kBert, InReach{kAnna, false});
  trio.give(kBert, Want{{{street(50, 60)}}});
  trio.run_for(30, {kAnna});
  EXPECT_EQ(trio.granted(kBert), 0);
  EXPECT_THAT(trio.whys(kBert), ElementsAre(Waits::Why{kAnna, Awaited::kToLeave}));
}

TEST(Standby, WhileItsOwnerIsInReachItKeepsNobodyFromThatAir) {
  for (const bool hear_each_other : {true, false}) {
    Trio trio = two();
    trio.give(kAnna, Need{{{street(0, 100)}}});
    trio.run_for(5);
    if (!hear_each_other) hear_each_other_no_more(trio);
    trio.give(kBert, Want{{{street(50, 60)}}});
    trio.run_for(2);
    EXPECT_EQ(trio.granted(kBert), 1) << hear_each_other;

    trio.is_alone(kAnna);
    trio.give(kAnna, Want{{{street(0, 100)}}});
    trio.run_for(30, {kAnna});
    EXPECT_EQ(trio.granted(kAnna), 0) << "the other has some of it";
  }
}

TEST(Standby, OfTwoWaysHomeThatCrossTheFirstIsKept) {
  Trio trio = two();
  trio.give(kAnna, Need{{{street(0, 100)}}});
  trio.run_for(1);
  trio.give(kBert, Need{{{street(50, 150)}}});
  trio.run_for(12);
  trio.is_alone(kAnna);
  trio.give(kAnna, Want{{{street(0, 100)}}});
  EXPECT_EQ(trio.granted(kAnna), 1);
  trio.is_alone(kBert);
  trio.give(kBert, Want{{{street(50, 150)}}});
  trio.run_for(10);
  EXPECT_EQ(trio.granted(kBert), 0);
}

TEST(Standby, WhereTheFirstWayIsNotFreeTheNextIsKept) {
  Trio trio = two();
  trio.give(kAnna, Need{{{street(0, 100)}}});
  trio.run_for(1);
  trio.give(kBert, Need{{{street(50, 150)}, {street(200, 300)}}});
  trio.run_for(1);
  trio.is_alone(kBert);
  trio.give(kBert, Want{{{street(50, 150)}, {street(200, 300)}}});
  trio.run_for(1);
  EXPECT_EQ(trio.granted(kBert), 1);
  EXPECT_EQ(trio.member(kBert).held(), (Volumes{street(200, 300)}));
}

TEST(Standby, WhatAnotherHasLeftIsKeptAgain) {
  Trio trio = two();
  hear_each_other_no_more(trio);
  trio.give(kBert, Want{{{street(50, 60)}}});
  trio.run_for(1);
  trio.give(kAnna, Need{{{street(0, 100)}}});
  trio.run_for(1);
  trio.give(kBert, Hold{{}});
  trio.run_for(10);
  trio.is_alone(kAnna);
  trio.give(kAnna, Want{{{street(0, 100)}}});
  EXPECT_EQ(trio.granted(kAnna), 1);
}

TEST(Standby, ARequestForOtherAirStandsInItsPlaceUntilItIsOver) {
  Trio trio = two();
  trio.give(kAnna, Need{{{street(0, 100)}}});
  trio.run_for(1);
  trio.give(kAnna, Want{{{street(300, 400)}}});
  trio.run_for(3);
  ASSERT_EQ(trio.granted(kAnna), 1);
  trio.is_alone(kAnna);
  trio.give(kAnna, Want{{{street(0, 100)}}});
  EXPECT_EQ(trio.granted(kAnna), 2);
}

TEST(Standby, WhatIsNeededNoMoreIsKeptNoMore) {
  Trio trio = two();
  trio.give(kAnna, Need{{{street(0, 100)}}});
  trio.run_for(1);
  trio.give(kAnna, Need{});
  trio.run_for(1);
  trio.is_alone(kAnna);
  trio.give(kAnna, Want{{{street(0, 100)}}});
  EXPECT_EQ(trio.granted(kAnna), 0);
  trio.give(kBert, InReach{kAnna, false});
  trio.give(kBert, Want{{{street(50, 60)}}});
  trio.run_for(1, {kAnna});
  EXPECT_EQ(trio.granted(kBert), 1);
}

// ---- never two in one air ----

/// From here the other one wants some of it.
struct Start {
  const char* what;
  std::function<void(Trio&, const std::string&)> make;
};

std::vector<Start> starts() {
  const Need home{{{street(0, 100)}}}, elsewhere{{{street(300, 400)}}};
  return {{"nothing is kept yet", [=](Trio& trio, const auto& uav) { trio.give(uav, home); }},
          {"it is kept",
           [=](Trio& trio, const auto& uav) {
             trio.give(uav, home);
             trio.run_for(1);
           }},
          {"it is kept for long",
           [=](Trio& trio, const auto& uav) {
             trio.give(uav, home);
             trio.run_for(4);
           }},
          {"other air is asked for since",
           [=](Trio& trio, const auto& uav) {
             trio.give(uav, home);
             trio.run_for(1);
             trio.give(uav, Want{elsewhere.choices});
           }},
          {"other air was kept", [=](Trio& trio, const auto& uav) {
             trio.give(uav, elsewhere);
             trio.run_for(1);
             trio.give(uav, home);
           }}};
}

TEST(StandbySearch, WhoTakesItNeverMeetsAnotherInItInWhateverOrderAllIsHeard) {
  for (const Start& start : starts()) {
    for (const auto& [alone, other] : {std::pair(kAnna, kBert), std::pair(kBert, kAnna)}) {
      Trio trio = two();
      start.make(trio, alone);
      trio.give(other, Want{{{street(50, 150)}}});
      Exploration all(50, alone, street(0, 100));
      EXPECT_FALSE(all.finds_two(trio, 6)) << alone << ": " << start.what;
      EXPECT_GT(all.taken(), 0) << alone << ": " << start.what;
    }
  }
}

// By whose word the other has it nobody else knows.
TEST(Standby, WhoMayHaveForgottenTakesNothingBeforeAllHaveAnswered) {
  Trio trio = two();
  trio.give(kBert, Want{{{street(50, 60)}}});
  trio.run_for(1, {kGround});
  ASSERT_EQ(trio.granted(kBert), 1);
  trio.forget(kAnna);
  trio.give(kAnna, Need{{{street(0, 100)}}});
  trio.run_for(10, {kBert});
  trio.is_alone(kAnna);
  trio.give(kAnna, Want{{{street(0, 100)}}});
  EXPECT_EQ(trio.granted(kAnna), 0);
}

TEST(StandbySearch, NorDoTwoThatTakeWhatIsKeptForThem) {
  Trio trio = two();
  trio.give(kAnna, Need{{{street(0, 100)}}});
  trio.give(kBert, Need{{{street(50, 150)}}});
  trio.give(kBert, Want{{{street(90, 95)}}});
  trio.is_alone(kBert);
  trio.give(kBert, Want{{{street(50, 150)}}});
  Exploration all(50, kAnna, street(0, 100));
  EXPECT_FALSE(all.finds_two(trio, 6));
}

// That the search finds what there is to find: two witnesses are none.
TEST(StandbySearch, WhereEachHasItsOwnWitnessTheSameSearchFindsTwo) {
  Trio trio({{kAnna, "one"}, {kBert, "another"}});
  trio.give(kAnna, Need{{{street(0, 100)}}});
  trio.run_for(1);
  trio.give(kAnna, InReach{kBert, false});
  trio.give(kBert, InReach{kAnna, false});
  trio.give(kBert, Want{{{street(50, 150)}}});
  Exploration all(50, kAnna, street(0, 100));
  EXPECT_TRUE(all.finds_two(trio, 6));
}

}  // namespace
}  // namespace skein::merging
