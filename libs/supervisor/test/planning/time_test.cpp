// SPDX-License-Identifier: Apache-2.0
// Timelines, numbers and time constraints of plans.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/planning_lab.hpp"

namespace skein::supervisor {
namespace {

using namespace std::string_literals;
using mission::DependenceKind;
using mission::Interval;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::PlanningLab;

MissionTime at(double s) { return MissionTime::seconds(s); }
Interval seconds(double least, double most) {
  return {Duration::seconds(least), Duration::seconds(most)};
}

PlanningLab flying() {
  PlanningLab lab;
  lab.flying_at({0, 0, 40}).first_id(1);
  return lab;
}

TEST(PlanningTime, NumbersBeginWhereTheSituationSays) {
  PlanningLab lab = flying();
  lab.first_id(4711).task(1, "takeshot-while-waiting", {5.0});

  const auto plan = lab.plan();

  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->tasks[0].id, executive::TaskId(4711));
  EXPECT_EQ(plan->tasks[1].id, executive::TaskId(4712));
}

TEST(PlanningTime, FirstTasksWaitForWhatStands) {
  PlanningLab lab = flying();
  lab.situation.motion = {seconds(10, 20), {{DependenceKind::kEnded, executive::TaskId(9)}}};
  lab.task(1, "general-gotoxyz", {"P1"s});

  const auto plan = lab.plan();

  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->tasks[0].start, seconds(10, 20));
  EXPECT_THAT(plan->tasks[0].dependences,
              ElementsAre(mission::Dependence{DependenceKind::kEnded, executive::TaskId(9)}));
}

TEST(PlanningTime, WhatTakesThePlaceOfAWithdrawnTaskWaitsUntilThatIsOver) {
  PlanningLab lab = flying();
  lab.situation.motion.after = {DependenceKind::kOver, executive::TaskId(33)};
  lab.task(1, "general-gotoxyz", {"P1"s});

  const auto plan = lab.plan();

  ASSERT_TRUE(plan);
  EXPECT_THAT(plan->tasks[0].dependences,
              ElementsAre(mission::Dependence{DependenceKind::kOver, executive::TaskId(33)}));
}

TEST(PlanningTime, APerceptionWaitsForItsDevice) {
  PlanningLab lab = flying();
  lab.situation.devices["singlecam"] = {seconds(50, 60),
                                        {{DependenceKind::kOver, executive::TaskId(8)}}};
  lab.task(1, "takeshot-while-waiting", {5.0});

  const auto plan = lab.plan();

  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->tasks[1].start, seconds(50, 60));
  EXPECT_THAT(plan->tasks[1].dependences,
              ElementsAre(mission::Dependence{DependenceKind::kRunning, executive::TaskId(1)},
                          mission::Dependence{DependenceKind::kOver, executive::TaskId(8)}));
}

TEST(PlanningTime, AnUnknownEndOfWhatStandsIsUnknownAfterwards) {
  PlanningLab lab = flying();
  lab.situation.motion.free = {Duration::seconds(5), Duration::max()};
  lab.task(1, "general-wait", {5.0}).task(2, "general-wait", {5.0});

  const auto plan = lab.plan();

  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->tasks[1].start, (Interval{Duration::seconds(10), Duration::max()}));
}

TEST(PlanningTime, EveryTaskOfAHighLevelTaskInheritsItsConstraints) {
  PlanningLab lab;
  const mission::TimeConstraints time{at(500), at(20), at(600), std::nullopt};
  lab.task(1, "general-combined-goto-and-takeshot", {"P1"s, 5.0}, time).task(2, "general-land");

  const auto plan = lab.plan();

  ASSERT_TRUE(plan);
  for (const auto& task : plan->tasks)
    EXPECT_EQ(task.time, task.origin == mission::GoalId(1) ? time : mission::TimeConstraints{});
}

TEST(PlanningTime, StartAfterPushesTheStart) {
  PlanningLab lab = flying();
  lab.task(1, "general-wait", {5.0}, {std::nullopt, at(100), std::nullopt, std::nullopt});
  lab.task(2, "general-wait", {5.0});

  const auto plan = lab.plan();

  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->tasks[0].start, seconds(100, 100));
  EXPECT_EQ(plan->tasks[1].start, seconds(105, 105));
}

TEST(PlanningTime, EndAfterPushesTheStartByNoMoreThanNeeded) {
  PlanningLab lab = flying();
  lab.task(1, "general-wait", {5.0}, {std::nullopt, std::nullopt, std::nullopt, at(100)});

  const auto plan = lab.plan();

  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->tasks[0].start, seconds(95, 95));
}

TEST(PlanningTime, ConstraintsCountInMissionTimeWhateverTheOrigin) {
  PlanningLab lab = flying();
  lab.situation.origin = at(1000);
  lab.task(1, "general-wait", {5.0}, {std::nullopt, at(1100), std::nullopt, std::nullopt});

  const auto plan = lab.plan();

  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->origin, at(1000));
  EXPECT_EQ(plan->tasks[0].start, seconds(100, 100));
  EXPECT_EQ(plan->tasks[0].time.start_after, at(1100));
}

TEST(PlanningTime, APlanThatMightStartTooLateIsRefusedWithFigures) {
  PlanningLab lab;
  lab.situation.origin = at(1000);
  lab.task(1, "general-takeoff");
  lab.task(2, "general-gotoxyz", {"P1"s}, {at(1005), std::nullopt, std::nullopt, std::nullopt});

  const auto plan = lab.plan();

  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().culprit, mission::GoalId(2));
  EXPECT_THAT(
      plan.error().reasons,
      ElementsAre("gotoxyz of goal 2 starts between 1004 s and 1006 s, but must start before "
                  "1005 s"));
}

TEST(PlanningTime, APlanThatMightEndTooLateIsRefusedWithFigures) {
  PlanningLab lab = flying();
  lab.task(2, "general-wait", {50.0}, {std::nullopt, std::nullopt, at(49), std::nullopt});

  EXPECT_EQ(lab.reasons(), "wait of goal 2 ends between 50 s and 50 s, but must end before 49 s\n");
}

TEST(PlanningTime, FiguresAreRoundedWheneverItIsPlanned) {
  PlanningLab lab = flying();
  lab.situation.origin = at(1000) + Duration::nanoseconds(1);
  lab.task(2, "general-wait", {50.0}, {std::nullopt, std::nullopt, at(1049), std::nullopt});

  EXPECT_EQ(lab.reasons(),
            "wait of goal 2 ends between 1050 s and 1050 s, but must end before 1049 s\n");
}

TEST(PlanningTime, BoundsThatAreJustKeptAreKept) {
  PlanningLab lab = flying();
  lab.task(2, "general-wait", {50.0}, {at(0), at(0), at(50), at(50)});

  EXPECT_TRUE(lab.plan()) << lab.reasons();
}

TEST(PlanningTime, WhatMustEndInTimeCannotFollowWhatMayLastForEver) {
  PlanningLab lab = flying();
  lab.task(1, "wait-for-orders");
  lab.task(2, "general-wait", {5.0}, {std::nullopt, std::nullopt, at(900), std::nullopt});

  EXPECT_THAT(lab.reasons(), HasSubstr("an unknown time, but must end before 900 s"));
}

}  // namespace
}  // namespace skein::supervisor
