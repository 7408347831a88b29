// SPDX-License-Identifier: Apache-2.0
// Urgent tasks before they start, and the background routine: each without an executive.
#include "urgents.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "background.hpp"

namespace skein::executive {
namespace {

/// Tasks in a plan; those of `wait` are urgent.
class Waiting {
 public:
  Plan::Slot add(std::uint64_t id) {
    return plan.insert(Task{TaskId{id}, "goto", {}, {}, {}, {}}, false);
  }
  Plan::Slot wait(std::uint64_t id, const std::set<TaskId>& blockers, bool moves = true) {
    const Plan::Slot slot = add(id);
    plan[slot].urgent = true;
    urgents.enter(plan[slot], slot, blockers, moves);
    return slot;
  }
  std::optional<TaskId> take() {
    const auto slot = urgents.take(plan);
    return slot ? std::optional(plan[*slot].id) : std::nullopt;
  }

  Plan plan;
  Urgents urgents;
};

TEST(Urgents, GoAtOnceWhenNobodyIsInTheirWay) {
  Waiting waiting;
  waiting.wait(2, {});
  waiting.wait(1, {});

  EXPECT_EQ(waiting.take(), TaskId{1});
  EXPECT_EQ(waiting.take(), TaskId{2});
  EXPECT_FALSE(waiting.take());
}

TEST(Urgents, WaitUntilTheLastOneInTheirWayIsOver) {
  Waiting waiting;
  waiting.wait(3, {TaskId{1}, TaskId{2}});

  waiting.urgents.over(TaskId{1}, waiting.plan);
  EXPECT_FALSE(waiting.take());
  waiting.urgents.over(TaskId{1}, waiting.plan);
  EXPECT_FALSE(waiting.take());
  waiting.urgents.over(TaskId{2}, waiting.plan);
  EXPECT_EQ(waiting.take(), TaskId{3});
}

TEST(Urgents, ThatAreForcedWaitForNobody) {
  Waiting waiting;
  const Plan::Slot slot = waiting.wait(3, {TaskId{1}});

  waiting.urgents.force(waiting.plan[slot], slot);

  EXPECT_EQ(waiting.take(), TaskId{3});
  waiting.urgents.over(TaskId{1}, waiting.plan);
  EXPECT_FALSE(waiting.take());
}

TEST(Urgents, ThatWereCancelledMeanwhileDoNotGo) {
  Waiting waiting;
  const Plan::Slot slot = waiting.wait(3, {TaskId{1}});
  waiting.plan.set_state(slot, TaskState::kAborted);
  waiting.urgents.leave(waiting.plan[slot]);

  waiting.urgents.over(TaskId{1}, waiting.plan);

  EXPECT_FALSE(waiting.take());
  EXPECT_FALSE(waiting.plan[slot].urgent);
}

TEST(Urgents, KeepTheVehicleForThoseThatAreAboutToMoveIt) {
  Waiting waiting;
  waiting.wait(3, {TaskId{1}}, false);
  EXPECT_FALSE(waiting.urgents.any_to_move());

  const Plan::Slot slot = waiting.wait(4, {TaskId{1}});
  EXPECT_TRUE(waiting.urgents.any_to_move());
  waiting.urgents.leave(waiting.plan[slot]);
  EXPECT_FALSE(waiting.urgents.any_to_move());
}

TEST(Urgents, ThatSomebodyElseHasWaitForNobodyAnyMore) {
  Waiting waiting;
  waiting.wait(3, {TaskId{1}});
  waiting.urgents.let_go(TaskId{3});

  waiting.urgents.over(TaskId{1}, waiting.plan);

  EXPECT_FALSE(waiting.take());
}

// --- the background routine ---

TEST(Background, IsWantedInFlightUntilOneRuns) {
  Background routine;
  EXPECT_FALSE(routine.wanted());
  routine.flies(true);
  EXPECT_TRUE(routine.wanted());

  EXPECT_EQ(routine.begin(), kFirstBackgroundId);
  EXPECT_FALSE(routine.wanted());
}

TEST(Background, ThatWasDisplacedIsWantedAgainAndThatWasRefusedAfterAPause) {
  Background routine;
  routine.flies(true);
  routine.begin();
  routine.over(false);
  EXPECT_TRUE(routine.wanted());

  EXPECT_GT(routine.begin(), kFirstBackgroundId);
  routine.over(true);
  EXPECT_FALSE(routine.wanted());
  routine.retry();
  EXPECT_TRUE(routine.wanted());
}

TEST(Background, RestsUntilItIsToldNotTo) {
  Background routine;
  routine.flies(true);
  routine.rest(true);
  EXPECT_FALSE(routine.wanted());
  routine.rest(false);
  EXPECT_TRUE(routine.wanted());
}

TEST(Background, TasksThatEndInTheAirOrOnTheGroundTellWhetherItFlies) {
  Background routine;
  routine.left(functional::Leaves::kInTheAir);
  EXPECT_TRUE(routine.wanted());
  routine.left(functional::Leaves::kAsItWas);
  EXPECT_TRUE(routine.wanted());
  routine.left(functional::Leaves::kOnTheGround);
  EXPECT_FALSE(routine.wanted());
}

}  // namespace
}  // namespace skein::executive
