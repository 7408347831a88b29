// SPDX-License-Identifier: Apache-2.0
// Tasks that another executive takes over. Source: spec 1.2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/mission.hpp"

namespace skein::executive {
namespace {

using testing::ce;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::Mission;
using testing::optional;
using ::testing::SizeIs;
using testing::TaskOf;
using enum TaskState;

// 1 ended, 2 runs, 3 waits for it.
Mission under_way() {
  Mission mission;
  mission.start(TaskOf(1, "takeoff"));
  mission.ends(1);
  mission.start(TaskOf(2, "goto"));
  mission.runs(2);
  mission.start(TaskOf(3, "land").pre({ce(2, kEnded)}));
  return mission;
}

TEST(Relinquish, TakesWhatIsNotTerminalOutOfThePlanInSilence) {
  Mission mission = under_way();

  EXPECT_THAT(mission.give(Relinquish{}), IsEmpty());

  EXPECT_THAT(mission.notices, SizeIs(1));
  ASSERT_THAT(mission.executive.tasks(), SizeIs(1));
  EXPECT_EQ(mission.state_of(1), kEnded);
}

TEST(Relinquish, OfNothingSaysNothing) {
  Mission mission;

  EXPECT_THAT(mission.give(Relinquish{}), IsEmpty());
  EXPECT_THAT(mission.notices, IsEmpty());
}

TEST(Relinquish, LetsEachTaskBeStartedAgainAndRefusesTheOthers) {
  Mission mission = under_way();
  mission.give(Relinquish{});

  mission.start(TaskOf(1, "takeoff"));
  EXPECT_EQ(mission.why(), "id 1 is known already");
  EXPECT_THAT(mission.start(TaskOf(2, "goto")),
              ElementsAre("2 scheduled", "2 started", "dispatch 2"));
  mission.start(TaskOf(2, "goto"));
  EXPECT_EQ(mission.why(), "id 2 is known already");
}

TEST(Relinquish, WhatCameBackRunsLikeAnyOther) {
  Mission mission = under_way();
  mission.give(Relinquish{});
  mission.start(TaskOf(2, "goto"));
  mission.start(TaskOf(3, "land").pre({ce(2, kEnded)}).pre({ce(1, kEnded)}));

  EXPECT_THAT(mission.runs(2), ElementsAre("2 running"));
  EXPECT_THAT(mission.ends(2), ElementsAre("2 ended", "3 started", "dispatch 3"));
}

TEST(Relinquish, KeepsTheTasksFromTheGivenIdOn) {
  Mission mission = under_way();
  mission.start(TaskOf(900, "takeshot").device("camera"));

  mission.give(Relinquish{TaskId{900}});

  EXPECT_THAT(mission.executive.tasks(), SizeIs(2));
  EXPECT_THAT(mission.ends(900), ElementsAre("900 ended"));
}

// What is left sees a relinquished task as aborted.
TEST(Relinquish, LetsWhatStaysGoOnWithoutTheOthers) {
  Mission mission = under_way();
  mission.start(TaskOf(900, "wait").pre({optional(ce(3, kEnded))}));
  mission.start(TaskOf(901, "wait").pre({ce(3, kEnded)}));

  EXPECT_THAT(mission.give(Relinquish{TaskId{900}}),
              ElementsAre("900 started", "dispatch 900", "901 aborted"));
}

TEST(Relinquish, FreesTheResources) {
  Mission mission = under_way();
  mission.give(Relinquish{});

  EXPECT_THAT(mission.start(TaskOf(4, "goto"), InsertionMode::kVut),
              ElementsAre("4 scheduled", "4 started", "dispatch 4"));
}

TEST(Relinquish, ForgetsTheTimesThatTheTasksWaitedFor) {
  Config config = testing::named("marvin");
  config.functional_timeout = Duration::seconds(20);
  Mission mission(config);
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "goto").pre({testing::passed(50)}));

  mission.give(Relinquish{});

  EXPECT_EQ(mission.executive.next_wakeup(), std::nullopt);
  EXPECT_THAT(mission.at(100).tick(), IsEmpty());
}

TEST(Relinquish, DropsAnUrgentTaskThatWaits) {
  Mission mission = under_way();
  mission.start(TaskOf(4, "wait"), InsertionMode::kVut);

  mission.give(Relinquish{});

  EXPECT_THAT(mission.aborted(2), IsEmpty());
  EXPECT_THAT(mission.at(100).tick(), IsEmpty());
}

TEST(Relinquish, SendsNoSynchronisationMessageAgain) {
  Mission mission;
  mission.start(TaskOf(1, "synchronise").among({"marvin", "heliv"}, {"marvin", "heliv"}));

  mission.give(Relinquish{});

  EXPECT_THAT(mission.reachable("heliv"), IsEmpty());
  EXPECT_THAT(mission.sync_from("heliv"), IsEmpty());
}

// The message that came meanwhile counts.
TEST(Relinquish, ASynchronisationThatCameBackKnowsTheMessagesThatWereHeard) {
  Mission mission;
  mission.start(TaskOf(1, "synchronise").among({"marvin", "heliv"}, {"marvin", "heliv"}));
  mission.give(Relinquish{});
  mission.sync_from("heliv");

  EXPECT_THAT(
      mission.start(TaskOf(1, "synchronise").among({"marvin", "heliv"}, {"marvin", "heliv"})),
      ElementsAre("1 scheduled", "1 started", "1 running", "sync 551 to heliv", "1 ended"));
}

TEST(Relinquish, StopsTheBackgroundRoutineUntilTheNextStart) {
  Config config = testing::named("marvin");
  config.background_type = "wait";
  Mission mission(config);
  mission.flies();
  const std::uint64_t routine = kFirstBackgroundId.value();
  mission.runs(routine);

  EXPECT_THAT(mission.give(Relinquish{}), ElementsAre(std::to_string(routine) + " aborting",
                                                      "interrupt " + std::to_string(routine)));
  EXPECT_THAT(mission.aborted(routine), ElementsAre(std::to_string(routine) + " aborted"));
  EXPECT_THAT(mission.at(100).tick(), IsEmpty());
  mission.start(TaskOf(1, "goto"));
  EXPECT_THAT(mission.ends(1), ::testing::Contains("dispatch " + std::to_string(routine + 1)));
}

TEST(Relinquish, AJointTaskUnderWayNoLongerHasTheStatusesOfOthersForwarded) {
  Mission mission;
  mission.start(TaskOf(1, "joint:lift"));
  mission.give(Relinquish{});

  EXPECT_THAT(mission.start(TaskOf(2, "goto")),
              ElementsAre("2 scheduled", "2 started", "dispatch 2"));
}

}  // namespace
}  // namespace skein::executive
