// SPDX-License-Identifier: Apache-2.0
// The state that a plan starts from, and goals that need no tasks. Source: spec 3.3, 6.2.
#include "testing/core_harness.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using mission::Dependence;
using mission::DependenceKind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const world::Vector3 kThere{100, 0, 40}, kFar{500, 0, 40};

std::optional<Dependence> ended(std::uint64_t id) {
  return Dependence{DependenceKind::kEnded, TaskId{id}};
}
std::optional<Dependence> over(std::uint64_t id) {
  return Dependence{DependenceKind::kOver, TaskId{id}};
}

/// In the air at kThere; the goal 701 has these tasks, which the executive was given.
Desk in_hand(std::vector<mission::ElementaryTask> tasks) {
  Desk desk = Desk::engaged();
  desk.flies(kThere);
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, std::move(tasks)));
  return desk;
}

const Situation& asked_for(Desk& desk) {
  desk.add(a_mission(2, {702}));
  return desk.insertion().base.situation;
}

// ---- what holds the vehicle ----

TEST(Situation, WhatComesNextWaitsForWhateverHoldsTheVehicle) {
  for (const char* type : {"goto", "wait", "perceive", "rendezvous", "joint:track"}) {
    Desk desk = in_hand({TaskOf(100, type, 701).takes(30, 40)});
    desk.at(10).runs(100);

    const Situation& situation = asked_for(desk.at(20));

    EXPECT_EQ(situation.motion.after, ended(100)) << type;
    EXPECT_EQ(situation.motion.free, (mission::Interval{secs(20), secs(30)})) << type;
  }
}

TEST(Situation, APerceptionThatHoldsTheVehicleHoldsItsDeviceToo) {
  Desk desk = in_hand({TaskOf(100, "perceive", 701).takes(30, 40).device("camera")});

  const Situation& situation = asked_for(desk);

  EXPECT_EQ(situation.devices.at("camera").after, ended(100));
  EXPECT_EQ(situation.devices.at("camera").free, situation.motion.free);
}

TEST(Situation, MonitoringIsOverWhenItsStopIs) {
  Desk desk = in_hand({TaskOf(100, "monitor", 701).device("camera").stopped_by(101),
                       TaskOf(101, "synchronise", 701).during(100).takes(30, 40)});

  const Situation& situation = asked_for(desk);

  EXPECT_EQ(situation.motion.after, over(100));
  EXPECT_EQ(situation.motion.free, (mission::Interval{secs(30), secs(40)}));
  ASSERT_THAT(situation.riders, SizeIs(1));
  EXPECT_EQ(situation.riders[0].after, ended(101));
}

TEST(Situation, WhatRunsAlongWithTheLastMotionIsOverAfterIt) {
  Desk desk = in_hand({TaskOf(100, "goto", 701).takes(30, 40),
                       TaskOf(101, "takeshot", 701).during(100).device("camera").stopped_by(100)});

  const Situation& situation = asked_for(desk);

  EXPECT_EQ(situation.motion.after, ended(100));
  ASSERT_THAT(situation.riders, SizeIs(1));
  EXPECT_EQ(situation.riders[0].after, over(101));
  EXPECT_EQ(situation.riders[0].free, (mission::Interval{secs(30), secs(40)}));
  EXPECT_EQ(situation.devices.at("camera").after, over(101));
}

TEST(Situation, WhatRanAlongWithAnEarlierMotionIsNothingToWaitForTwice) {
  Desk desk = in_hand({TaskOf(100, "goto", 701),
                       TaskOf(101, "takeshot", 701).during(100).device("camera").stopped_by(100),
                       TaskOf(102, "wait", 701).after(101).after(100)});

  EXPECT_THAT(asked_for(desk).riders, IsEmpty());
}

TEST(Situation, ATakeshotWhoseMotionHasEndedIsOverSoon) {
  Desk desk = in_hand({TaskOf(100, "goto", 701),
                       TaskOf(101, "takeshot", 701).during(100).device("camera").stopped_by(100)});
  desk.runs(100);
  desk.runs(101);
  desk.at(15).ends(100);

  const Situation& situation = asked_for(desk);

  ASSERT_THAT(situation.riders, SizeIs(1));
  EXPECT_EQ(situation.riders[0].free, (mission::Interval{secs(0), secs(0)}));
}

TEST(Situation, WhatWasToldToStopIsOverBeforeItsDeviceIsUsedAgain) {
  Desk desk = in_hand({TaskOf(100, "takeshot", 701).device("camera").takes(30, 40)});
  desk.runs(100);
  mission::UnitMission urgent = a_mission(2, {702});
  urgent.placement = mission::Placement::kFirst;
  urgent.interrupt = true;

  desk.add(urgent);
  EXPECT_EQ(desk.insertion().base.situation.devices.at("camera").after, over(100));
  desk.finish(inserted({702, 701}, {TaskOf(101, "takeshot", 702).device("camera"),
                                    TaskOf(102, "takeshot", 701).device("camera").after(101)}));

  const auto start = desk.started(101);
  ASSERT_TRUE(start);
  ASSERT_THAT(start->task.preconditions, SizeIs(1));
  const auto& waits = std::get<executive::TaskInState>(start->task.preconditions[0][0].condition);
  EXPECT_EQ(waits.task, TaskId{100});
}

// ---- where it is ----

TEST(Situation, AWaitOnTheGroundIsNoFlight) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "wait", 701).takes(60, 60)}));
  desk.runs(100);

  EXPECT_FALSE(asked_for(desk.at(20)).airborne);
}

TEST(Situation, ItFliesAfterATakeoffAndNotAfterALanding) {
  Desk up = Desk::engaged();
  up.add(a_mission(1, {701}));
  up.finish(inserted({701}, {TaskOf(100, "takeoff", 701), TaskOf(101, "wait", 701).after(100)}));
  EXPECT_TRUE(asked_for(up).airborne);

  Desk down = in_hand({TaskOf(100, "land", 701), TaskOf(101, "wait", 701).after(100)});
  EXPECT_FALSE(asked_for(down).airborne);
}

TEST(Situation, ItIsWhereTheLastWayEndsWhateverComesAfter) {
  Desk desk = in_hand({TaskOf(100, "goto", 701).way({kThere, kFar}),
                       TaskOf(101, "perceive", 701).after(100).takes(60, 60)});

  EXPECT_EQ(asked_for(desk).position, kFar);
}

// ---- safety ----

TEST(Occupation, APerceptionAfterATakeshotWithTheSameDeviceIsOne) {
  Desk desk = in_hand({TaskOf(100, "goto", 701),
                       TaskOf(101, "takeshot", 701).during(100).device("camera").stopped_by(100),
                       TaskOf(102, "perceive", 701).after(101).device("camera")});
  desk.runs(100);
  desk.runs(101);
  desk.ends(100);

  desk.aborted(101, "exit conditions satisfied");

  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_THAT(desk.notices(), IsEmpty());
}

// ---- goals without tasks ----

/// 701 goes to kThere (100), 702 is to be there, too, and 703 goes on to kFar (101).
Desk with_one_without_tasks() {
  Desk desk = Desk::engaged();
  desk.flies({0, 0, 40});
  desk.add(a_mission(1, {701, 702, 703}));
  desk.finish(inserted({701, 702, 703},
                       {TaskOf(100, "goto", 701).takes(100, 120).way({{0, 0, 40}, kThere}),
                        TaskOf(101, "goto", 703).after(100).takes(50, 60).way({kThere, kFar})}));
  desk.runs(100);
  return desk;
}

TEST(GoalWithoutTasks, IsAchievedWhenItsTurnComes) {
  Desk desk = with_one_without_tasks();
  EXPECT_EQ(desk.state_of(702), "planned");
  desk.at(95).give(Tick{});  // 703 is given
  ASSERT_TRUE(desk.started(101));
  EXPECT_EQ(desk.state_of(702), "planned");

  desk.at(110).flies(kThere);
  desk.ends(100);

  EXPECT_THAT(desk.goals(), ElementsAre("701 achieved", "702 achieved"));
}

TEST(GoalWithoutTasks, IsAchievedAtOnceWhenNothingComesBeforeIt) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));

  desk.finish(inserted({701}, {}));

  EXPECT_THAT(desk.goals(), ElementsAre("701 planned", "701 achieved"));
}

TEST(GoalWithoutTasks, IsPlannedAnewWhenWhatItReliedOnIsCancelled) {
  Desk desk = with_one_without_tasks();

  desk.give(CancelMission{{{GoalId{701}}, {}, true}, "test"});

  EXPECT_EQ(desk.state_of(702), "planned");
  ASSERT_TRUE(desk.job_started());
  ASSERT_THAT(desk.repair().remaining, SizeIs(2));
  EXPECT_EQ(desk.repair().remaining[0].id, GoalId{702});
}

TEST(GoalWithoutTasks, IsPlannedAgainWhenItIsNotTrueAfterAll) {
  Desk desk = with_one_without_tasks();

  desk.at(110).flies({0, 300, 40});
  desk.ends(100);

  EXPECT_EQ(desk.state_of(701), "achieved");
  EXPECT_EQ(desk.state_of(702), "planned");
  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().failed->id, GoalId{702});
}

TEST(GoalWithoutTasks, IsNotMovedBehindWhatWasGivenAfterIt) {
  Desk desk = with_one_without_tasks();
  desk.at(95).give(Tick{});
  ASSERT_TRUE(desk.started(101));

  desk.add(a_mission(2, {704}));

  EXPECT_THAT(desk.insertion().planned, IsEmpty());
  desk.finish(inserted({704}, {TaskOf(102, "goto", 704).after(101)}));
  desk.at(110).flies(kThere);
  desk.ends(100);
  EXPECT_EQ(desk.state_of(702), "achieved");
}

TEST(GoalWithoutTasks, ToLandIsNotTrueInTheAir) {
  Desk desk = in_hand({TaskOf(100, "land", 701).takes(30, 40).way({kThere, {100, 0, 0}})});
  desk.add(a_mission(2, {702}));
  desk.finish(inserted({702}, {}));
  desk.runs(100);
  EXPECT_EQ(desk.state_of(702), "planned");

  desk.at(31).flies({100, 0, 1});
  EXPECT_EQ(desk.state_of(702), "planned");
  desk.ends(100);

  EXPECT_EQ(desk.state_of(702), "achieved");
}

// ---- missions of which some cannot be done ----

TEST(PartOfAMission, ThatCannotBeDoneIsNamedToAllOfIt) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701, 702}));
  InsertionOutcome none = refused("no way to P9");
  none.dropped = {{GoalId{702}, "no way to P9"}};

  desk.finish(none);

  EXPECT_EQ(desk.why_of(702), "no way to P9");
  EXPECT_EQ(desk.why_of(701),
            "all or nothing of the mission is planned; goal 702 (go 1): no way to P9");
  ASSERT_THAT(desk.of<MissionDecided>(), SizeIs(1));
  EXPECT_THAT(desk.of<MissionDecided>()[0].outcome.reasons,
              ElementsAre("goal 702 (go 1): no way to P9"));
}

TEST(PartOfAMission, IsLeftOutWhenTheMissionAllowsIt) {
  Desk desk = Desk::engaged();
  mission::UnitMission any = a_mission(1, {701, 702});
  any.any = true;
  desk.add(any);
  EXPECT_TRUE(desk.insertion().any);
  InsertionOutcome part = inserted({701}, {TaskOf(100, "goto", 701)});
  part.dropped = {{GoalId{702}, "no way to P9"}};

  desk.finish(part);

  EXPECT_TRUE(desk.of<MissionDecided>()[0].outcome.planned);
  EXPECT_EQ(desk.state_of(701), "planned");
  EXPECT_EQ(desk.state_of(702), "failed");
  EXPECT_EQ(desk.why_of(702), "no way to P9");
  const auto told = desk.of<Decided>();
  const auto inserted = std::find_if(told.begin(), told.end(), [](const Decided& one) {
    return one.decision.applied.starts_with("1 insert");
  });
  ASSERT_NE(inserted, told.end());
  EXPECT_THAT(inserted->decision.outcome, HasSubstr("left out goal 702"));
}

TEST(Reasons, NameGoalsNotTasks) {
  Desk desk = flying();
  desk.at(30).aborted(101);
  RepairOutcome without = repaired(RepairStep::kDrop, {702}, {TaskOf(104, "goto", 702)});
  without.dropped = {{GoalId{701}, "lost task 101"}};

  desk.finish(without);

  EXPECT_EQ(desk.why_of(701),
            "the goto of goal 701 (go 1) aborted: engine trouble; lost the goto of goal 701");
}

TEST(SupervisorTrueGoal, FromWhoseEndAnotherIsCountedGivesThatItsDate) {
  Desk desk = Desk::engaged();
  desk.flies(kThere);
  mission::UnitMission mission = a_mission(1, {701, 702, 703});
  mission.tasks[2].after.push_back({GoalId{702}, false, secs(50), secs(90)});
  desk.add(mission);
  InsertionOutcome outcome =
      inserted({701, 702, 703}, {TaskOf(100, "goto", 701).way({kFar, kThere}),
                                 TaskOf(101, "goto", 703).after(100).way({kThere, kFar})});
  outcome.order = mission.tasks;
  desk.finish(outcome);
  desk.runs(100);

  desk.at(15).ends(100);

  EXPECT_EQ(desk.state_of(702), "achieved");
  EXPECT_FALSE(desk.started(101).has_value());
  EXPECT_THAT(desk.notices(), ::testing::Contains(HasSubstr("goal 703")));
  EXPECT_EQ(desk.supervisor.next_wakeup(), at(64));
  desk.at(64).give(Tick{});
  EXPECT_TRUE(desk.started(101).has_value());
}

}  // namespace
}  // namespace skein::supervisor
