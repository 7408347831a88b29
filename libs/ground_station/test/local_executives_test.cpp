// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/local_executives.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using executive::TaskState;
using functional::Verb;
using testing::a_task;
using testing::at;
using ::testing::ElementsAre;
using testing::id;
using testing::in_state;
using ::testing::IsEmpty;
using ::testing::SizeIs;

LocalExecutives for_two(std::optional<Duration> timeout = {}) {
  executive::Config config;
  config.functional_timeout = timeout;
  std::map<std::string, executive::Config> configs;
  for (const char* uav : {"marvin", "heliv"}) {
    config.name = uav;
    configs[uav] = config;
  }
  return LocalExecutives(std::move(configs));
}

/// 5 is running, 6 comes after it.
void begin_two(LocalExecutives& mles) {
  executive::Task after = a_task(6);
  after.preconditions = {in_state(5, TaskState::kEnded)};
  mles.of("marvin").handle(executive::Start{a_task(5), executive::InsertionMode::kSeq}, at(1));
  mles.of("marvin").handle(executive::Start{after, executive::InsertionMode::kSeq}, at(1));
  mles.of("marvin").handle(executive::FunctionalStatus{id(5), TaskState::kRunning, ""}, at(2));
}

TEST(LocalExecutives, RunFromWhenTheyAreAskedForUntilTheyAreLetGo) {
  LocalExecutives mles = for_two();
  EXPECT_TRUE(mles.can_run("marvin"));
  EXPECT_FALSE(mles.can_run("karma"));
  EXPECT_FALSE(mles.runs("marvin"));

  begin_two(mles);

  EXPECT_THAT(mles.running(), ElementsAre("marvin"));
  EXPECT_TRUE(mles.knows("marvin", id(5)));
  EXPECT_FALSE(mles.knows("heliv", id(5)));
  mles.let_go("marvin");
  EXPECT_FALSE(mles.runs("marvin"));
  EXPECT_FALSE(mles.knows("marvin", id(5)));
}

TEST(LocalExecutives, LetGoOfWhatIsNotOverWithItsStateAndConditions) {
  LocalExecutives mles = for_two();
  begin_two(mles);
  mles.of("marvin").handle(executive::Start{a_task(4), executive::InsertionMode::kSeq}, at(2));
  mles.of("marvin").handle(executive::Abort{id(4)}, at(2));
  mles.of("marvin").handle(executive::FunctionalStatus{id(4), TaskState::kAborted, ""}, at(2));

  const std::vector<mission::HeldTask> tasks = mles.let_go("marvin");

  ASSERT_THAT(tasks, SizeIs(2));
  EXPECT_EQ(tasks[0].task.id, id(5));
  EXPECT_EQ(tasks[0].state, TaskState::kRunning);
  EXPECT_TRUE(tasks[0].in_executive);
  EXPECT_EQ(tasks[1].task.id, id(6));
  EXPECT_EQ(tasks[1].task.preconditions, executive::Formula{in_state(5, TaskState::kEnded)});
}

TEST(LocalExecutives, AreToldOfAFlightOnlyWhenItIsNews) {
  LocalExecutives mles = for_two();

  EXPECT_TRUE(mles.note_flight("marvin", false));
  EXPECT_FALSE(mles.note_flight("marvin", false));
  EXPECT_TRUE(mles.note_flight("marvin", true));
  mles.let_go("marvin");
  EXPECT_TRUE(mles.note_flight("marvin", true));
}

TEST(LocalExecutives, KnowTheOpenTasksOfAGoal) {
  LocalExecutives mles = for_two();
  begin_two(mles);
  mles.note_origin("marvin", id(5), mission::GoalId(701));
  mles.note_origin("marvin", id(6), mission::GoalId(702));
  EXPECT_THAT(mles.open_tasks_of("marvin", mission::GoalId(701)), ElementsAre(id(5)));
  EXPECT_THAT(mles.open_tasks_of("heliv", mission::GoalId(701)), IsEmpty());

  mles.of("marvin").handle(executive::FunctionalStatus{id(5), TaskState::kEnded, ""}, at(3));

  EXPECT_THAT(mles.open_tasks_of("marvin", mission::GoalId(701)), IsEmpty());
  EXPECT_THAT(mles.open_tasks_of("marvin", mission::GoalId(702)), ElementsAre(id(6)));
}

TEST(LocalExecutives, WhatTheyWillHaveGivenUpMustNotBeBegun) {
  LocalExecutives mles = for_two(Duration::seconds(20));
  begin_two(mles);

  const SendFunctional begin = mles.to_begin("marvin", id(5), at(3));
  const SendFunctional interrupt = mles.to_interrupt("marvin", id(5));

  EXPECT_EQ(begin.request.verb, Verb::kDispatch);
  EXPECT_EQ(begin.request.type, "goto");
  EXPECT_EQ(begin.expires, at(23));
  EXPECT_EQ(interrupt.request.verb, Verb::kInterrupt);
  EXPECT_EQ(interrupt.expires, MissionTime::max());
}

TEST(LocalExecutives, WhatIsUnderWayIsAskedForAgainAsItWas) {
  LocalExecutives mles = for_two();
  begin_two(mles);

  const auto running = mles.under_way("marvin");
  mles.of("marvin").handle(executive::Abort{id(5)}, at(3));
  const auto aborting = mles.under_way("marvin");

  ASSERT_THAT(running, SizeIs(1));
  EXPECT_EQ(running[0].request.id, id(5));
  EXPECT_EQ(running[0].request.verb, Verb::kDispatch);
  ASSERT_THAT(aborting, SizeIs(1));
  EXPECT_EQ(aborting[0].request.verb, Verb::kInterrupt);
}

TEST(LocalExecutives, ThoseAreDueWhoseTimeHasCome) {
  LocalExecutives mles = for_two(Duration::seconds(20));
  EXPECT_EQ(mles.next_wakeup(), std::nullopt);
  mles.of("marvin").handle(executive::Start{a_task(5), executive::InsertionMode::kSeq}, at(1));
  mles.of("heliv").handle(executive::Start{a_task(5), executive::InsertionMode::kSeq}, at(4));

  EXPECT_EQ(mles.next_wakeup(), at(21));
  EXPECT_THAT(mles.due(at(20)), IsEmpty());
  EXPECT_THAT(mles.due(at(21)), ElementsAre("marvin"));
  EXPECT_THAT(mles.due(at(24)), ElementsAre("heliv", "marvin"));
}

}  // namespace
}  // namespace skein::ground_station
