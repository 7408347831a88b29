// SPDX-License-Identifier: Apache-2.0
// Goals and tasks as they are kept.
#include "testing/rooms.hpp"

#include <gmock/gmock.h>

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// 701 has 100 and 101 behind it, 702 has 102 behind 101.
struct TwoGoals : Rooms {
  TwoGoals() {
    goals({701, 702});
    plan({TaskOf(100, "goto", 701), TaskOf(101, "goto", 701).after(100),
          TaskOf(102, "goto", 702).after(101)});
  }
};

// A wait that is aborted before the synchronisation that is to end it is over for who waits for any
// end.
TEST(Book, WhatWaitsForTheEndOfATaskThatAnotherStopsWaitsForThatToo) {
  Rooms rooms;
  mission::ElementaryPlan plan;
  for (const std::uint64_t id : {100U, 101U, 102U}) {
    plan.tasks.emplace_back().id = TaskId{id};
    plan.tasks.back().origin = GoalId{701};
  }
  plan.tasks[0].stop = {{mission::DependenceKind::kEnded, TaskId{101}}};
  plan.tasks[1].dependences = {{mission::DependenceKind::kRunning, TaskId{100}}};
  plan.tasks[2].dependences = {{mission::DependenceKind::kEnded, TaskId{100}}};

  rooms.book.enter(plan);

  const mission::Dependence on_wait{mission::DependenceKind::kEnded, TaskId{100}};
  const mission::Dependence on_end{mission::DependenceKind::kEnded, TaskId{101}};
  EXPECT_THAT(rooms.book.tasks.at(TaskId{102}).task.dependences, ElementsAre(on_wait, on_end));
  EXPECT_EQ(rooms.book.tasks.at(TaskId{101}).task.dependences.size(), 1U);
}

TEST(Book, NumbersNewTasksBeyondAllThatItKnows) {
  TwoGoals rooms;
  EXPECT_EQ(rooms.book.next_id, TaskId{103});

  EXPECT_EQ(rooms.book.add_loose("wait"), TaskId{103});
  EXPECT_EQ(rooms.book.next_id, TaskId{104});
}

TEST(Book, WithdrawsWhatIsWithTheExecutiveFromTheEndAndForgetsWhatIsOnlyPlanned) {
  TwoGoals rooms;
  rooms.gave({100, 101});

  EXPECT_THAT(rooms.book.withdraw({GoalId{701}, GoalId{702}}),
              ElementsAre(TaskId{101}, TaskId{100}));
  EXPECT_THAT(rooms.book.of(GoalId{702}), IsEmpty());
  EXPECT_THAT(rooms.book.withdraw({GoalId{701}}), IsEmpty());
}

TEST(Book, AGoalIsWhollyGivenWhenAllOfItsTasksAre) {
  TwoGoals rooms;
  rooms.gave({100});
  EXPECT_TRUE(rooms.book.is_given(GoalId{701}));
  EXPECT_FALSE(rooms.book.is_wholly_given(GoalId{701}));
  EXPECT_FALSE(rooms.book.is_planned(GoalId{701}));

  rooms.gave({101});
  EXPECT_TRUE(rooms.book.is_wholly_given(GoalId{701}));
  EXPECT_TRUE(rooms.book.is_planned(GoalId{702}));
}

TEST(Book, WhatWaitsForALostTaskFallsWithItsGoal) {
  TwoGoals rooms;
  rooms.gave({100, 101, 102});

  EXPECT_THAT(rooms.book.falling_with({GoalId{701}}), ElementsAre(GoalId{701}, GoalId{702}));
  EXPECT_THAT(rooms.book.falling_with({GoalId{702}}), ElementsAre(GoalId{702}));
}

TEST(Book, WhatIsDoneTakesNothingWithIt) {
  TwoGoals rooms;
  rooms.gave({100, 101, 102}).started(100).ended(100).started(101).ended(101);

  EXPECT_THAT(rooms.book.falling_with({GoalId{701}}), ElementsAre(GoalId{701}));
}

TEST(Book, GoalsAreFreeUntilTheyAreGivenQueuedOrSettled) {
  TwoGoals rooms;
  rooms.goals({703, 704, 705});
  rooms.gave({100});
  rooms.book.goals.at(GoalId{703}).queued = true;
  rooms.book.goals.at(GoalId{704}).state = GoalState::kHandedOver;

  EXPECT_THAT(rooms.book.free_goals(), ElementsAre(GoalId{702}, GoalId{705}));
}

TEST(Book, PutsSettledGoalsFirstAndKeepsTheOrderOtherwise) {
  Rooms rooms;
  rooms.goals({701, 702, 703});
  rooms.book.goals.at(GoalId{702}).state = GoalState::kAchieved;

  (void)rooms.book.goals_settled_first();

  EXPECT_THAT(rooms.book.order, ElementsAre(GoalId{702}, GoalId{701}, GoalId{703}));
}

TEST(Book, NamesAGoalByWhatItAsksFor) {
  Rooms rooms;
  rooms.goals({701});
  EXPECT_EQ(rooms.book.named(GoalId{701}), "goal 701 (go 1)");
  EXPECT_EQ(rooms.book.named(GoalId{9}), "goal 9");
}

TEST(Book, AWithdrawnMotionHoldsTheVehicleUntilItIsOver) {
  TwoGoals rooms;
  rooms.gave({100});
  rooms.book.withdraw({GoalId{701}});
  EXPECT_THAT(rooms.book.loose_motion(TaskId{103}), ElementsAre(TaskId{100}));

  rooms.lost(100);
  EXPECT_THAT(rooms.book.loose_motion(TaskId{103}), IsEmpty());
}

}  // namespace
}  // namespace skein::supervisor
