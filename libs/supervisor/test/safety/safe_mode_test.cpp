// SPDX-License-Identifier: Apache-2.0
// What a UAV in the air does when there is nothing to do.
#include "safety/safe_mode.hpp"

#include <gmock/gmock.h>

#include "testing/rooms.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// In the air; 701, a flight, is over.
struct Idle : Rooms {
  Idle() {
    at(0).goals({701}).plan({TaskOf(100, "goto", 701)});
    flies().committer.commit();
    started(100).at(15).ended(100);
    book.goals.at(GoalId{701}).state = GoalState::kAchieved;
    out.close();
  }
  std::vector<std::string> kept() {
    safe_mode.keep();
    return requests();
  }
  std::vector<std::string> said() {
    safe_mode.keep();
    return notices();
  }
};

TEST(SafeMode, OneWithNothingToDoWaits) {
  Idle rooms;
  EXPECT_THAT(rooms.kept(), ElementsAre("START 101"));
  EXPECT_THAT(rooms.kept(), IsEmpty());
}

TEST(SafeMode, SaysWhatIsOverAndWhatItWaitsFor) {
  Idle rooms;
  EXPECT_THAT(rooms.said(), ElementsAre(HasSubstr("nothing follows goal 701 (go 1), achieved")));

  Idle repaired;
  repaired.agenda.plan_anew(std::nullopt, false, "the wind turned");
  EXPECT_THAT(repaired.said(),
              ElementsAre(HasSubstr("its plan is to be repaired: the wind turned")));

  Idle later;
  later.goals({702}).plan({TaskOf(200, "goto", 702).starts_after(300)});
  EXPECT_THAT(
      later.said(),
      ElementsAre(HasSubstr("goal 702 (go 1) waits: nothing of it may begin before 300 s")));
}

// Found by missions of an outsider (184): a job of planning took 11 s, and nothing named the goal.
TEST(SafeMode, SaysWhichGoalWaitsUntilThePlanIsRepaired) {
  Idle rooms;
  rooms.goals({702}).plan({TaskOf(200, "goto", 702).starts_after(300)});
  rooms.agenda.plan_anew(std::nullopt, false, "the wind turned");
  EXPECT_THAT(rooms.said(),
              ElementsAre(HasSubstr("the wind turned; until then goal 702 (go 1) waits")));
}

TEST(SafeMode, OnTheGroundThereIsNothingToKeep) {
  Idle rooms;
  rooms.beliefs.see(world::VehicleState{}, {}, at(16));
  EXPECT_THAT(rooms.kept(), IsEmpty());
}

TEST(SafeMode, AWaitThatWasRefusedIsNotAskedForBeforeItsTime) {
  Idle rooms;
  rooms.safe_mode.pause_until(at(25));
  EXPECT_THAT(rooms.said(), ElementsAre(HasSubstr("its safe wait was refused or aborted")));
  EXPECT_THAT(rooms.said(), IsEmpty());

  EXPECT_THAT(rooms.at(25).notices(), IsEmpty());
  EXPECT_THAT(rooms.kept(), ElementsAre("START 101"));
}

// An urgent task does not wait for it longer than 10 s, and one that is low lands all the same.
TEST(SafeMode, OneThatStopsLandingWaitsWhenThatIsOver) {
  Idle rooms;
  rooms.goals({702}).plan({TaskOf(200, "land", 702)}).gave({200});
  rooms.started(200).committer.retire({GoalId{702}});
  rooms.requests();
  EXPECT_THAT(rooms.said(), ElementsAre(HasSubstr("until it has stopped landing")));
  rooms.at(40);
  EXPECT_THAT(rooms.kept(), IsEmpty());

  rooms.at(41).lost(200);
  EXPECT_THAT(rooms.kept(), ElementsAre(HasSubstr("START")));
}

TEST(SafeMode, OneThatWasNeverGivenAnythingIsOnlySpokenOf) {
  Rooms rooms;
  rooms.at(0).flies().safe_mode.keep();
  EXPECT_THAT(rooms.notices(),
              ElementsAre("in the air without a task: no mission was given to it"));
}

// Found by random missions of operators' orders: it waited for a message that never came.
TEST(SafeMode, SaysThatItsPlanWaitsForWhatAnOperatorLeftBehind) {
  Idle rooms;
  rooms.goals({702}).plan({TaskOf(200, "goto", 702)}).gave({200});
  rooms.book.loose[TaskId(7)] = {.type = "goto", .holds_vehicle = true};
  EXPECT_THAT(rooms.said(), IsEmpty()) << "it may begin in this instant";
  rooms.at(20);
  EXPECT_THAT(rooms.said(), ElementsAre(HasSubstr("goal 702 (go 1) waits for task 7 (goto)")));
  rooms.at(30);
  EXPECT_THAT(rooms.said(), IsEmpty());
}

// Found by random missions (--hands 990015): it had said so before the operator took it in hand.
TEST(SafeMode, WhoIsGivenBackSaysAgainWhatItsPlanWaitsFor) {
  Idle rooms;
  rooms.goals({702}).plan({TaskOf(200, "goto", 702)}).gave({200});
  rooms.book.loose[TaskId(7)] = {.type = "goto", .holds_vehicle = true};
  rooms.said();
  rooms.at(20);
  rooms.said();
  rooms.safe_mode.begin();
  rooms.at(30);
  rooms.said();
  rooms.at(36);

  EXPECT_THAT(rooms.said(), ElementsAre(HasSubstr("goal 702 (go 1) waits for task 7 (goto)")));
}

TEST(SafeMode, SaysNothingOfWhatAnOperatorPutBehindThePlan) {
  Idle rooms;
  rooms.goals({702}).plan({TaskOf(200, "goto", 702)}).gave({200});
  rooms.book.loose[TaskId(7)] = {.type = "goto", .holds_vehicle = true};
  EXPECT_THAT(rooms.said(), IsEmpty());
  rooms.started(200).at(20);
  EXPECT_THAT(rooms.said(), IsEmpty());
}

TEST(SafeMode, AShortPauseBeforeWhatTheExecutiveHasIsSaidButNotFilled) {
  Idle rooms;
  rooms.goals({702}).plan({TaskOf(200, "goto", 702).starts_after(25)});
  rooms.gave({200});
  EXPECT_THAT(rooms.said(), ElementsAre(HasSubstr("without a task for a moment")));
  rooms.at(21);
  EXPECT_THAT(rooms.kept(), IsEmpty());
}

}  // namespace
}  // namespace skein::supervisor
