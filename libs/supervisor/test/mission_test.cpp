// SPDX-License-Identifier: Apache-2.0
// Missions: checked, planned, given to the executive, achieved. Source: spec 6.2 (0, 1, 5).
#include "testing/core_harness.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Words = std::vector<std::string>;

// Goal 701 with two tasks, 702 with one that comes after them.
std::vector<mission::ElementaryTask> two_goals() {
  return {TaskOf(100, "takeoff", 701), TaskOf(101, "goto", 701).after(100).takes(100, 120),
          TaskOf(102, "goto", 702).after(101)};
}

Desk with_two_goals() {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701, 702}));
  desk.finish(inserted({701, 702}, two_goals()));
  return desk;
}

TEST(SupervisorMission, IsAnsweredInTheSameCallAndPlannedByAJob) {
  Desk desk = Desk::engaged();

  desk.add(a_mission(1, {701, 702}));

  ASSERT_EQ(desk.of<Answer>().size(), 1U);
  EXPECT_TRUE(desk.of<Answer>()[0].accepted);
  EXPECT_THAT(desk.goals(), ElementsAre("701 received", "702 received"));
  EXPECT_THAT(desk.decisions(), ElementsAre("0 user request"));
  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.insertion().added.size(), 2U);
  EXPECT_THAT(desk.insertion().planned, IsEmpty());
  EXPECT_EQ(desk.insertion().base.situation.next_id, TaskId{100});
}

TEST(SupervisorMission, ThatMakesNoSenseIsRefusedWithEveryReason) {
  Desk desk = with_two_goals();
  mission::UnitMission wrong = a_mission(1, {701});
  wrong.tasks[0].name = "gone";

  desk.add(wrong);

  ASSERT_FALSE(desk.of<Answer>()[0].accepted);
  EXPECT_THAT(desk.of<Answer>()[0].reasons, Contains(HasSubstr("'gone'")));
  EXPECT_THAT(desk.of<Answer>()[0].reasons, Contains("mission 1 is known already"));
  EXPECT_THAT(desk.of<Answer>()[0].reasons, Contains("high-level task 701 is known already"));
  EXPECT_FALSE(desk.job_started());
}

// Of what was over long ago only the numbers are known.
TEST(SupervisorMission, NumbersAreKnownHoweverManyMissionsCameAfter) {
  Desk desk = Desk::engaged();
  for (std::uint64_t id = 1; id <= 500; ++id) {
    desk.add(a_mission(id, {1000 + id}));
    desk.finish(refused("no way"));
  }
  mission::UnitMission again = a_mission(1, {1001});
  again.tasks[0].after.push_back({GoalId{1002}, false, Duration(), secs(60)});

  desk.add(again);

  ASSERT_FALSE(desk.of<Answer>()[0].accepted);
  EXPECT_THAT(desk.of<Answer>()[0].reasons,
              ElementsAre("mission 1 is known already", "high-level task 1001 is known already",
                          "high-level task 1002, after which 1001 is to come, is over for too long "
                          "to count from it"));
  desk.give(CancelMission{{{GoalId{1001}}, {}, true}, "test"});
  EXPECT_THAT(desk.of<Answer>()[0].reasons, ElementsAre("all of it is over already"));
}

TEST(SupervisorMission, IsRefusedWhileNotEngaged) {
  Desk desk;

  desk.add(a_mission(1, {701}));

  EXPECT_FALSE(desk.of<Answer>()[0].accepted);
  EXPECT_THAT(desk.supervisor.report().goals, IsEmpty());
}

TEST(SupervisorMission, ThatNeedsABrokenDeviceIsRefused) {
  Desk desk = Desk::engaged();
  desk.flies({0, 0, 0}, 1, {"camera"});
  mission::UnitMission looks = a_mission(1, {701});
  looks.tasks[0].name = "look";

  desk.add(looks);

  EXPECT_FALSE(desk.of<Answer>()[0].accepted);
}

TEST(SupervisorMission, PlannedIsToldAndItsFirstGoalGivenAtOnce) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701, 702}));

  desk.finish(inserted({701, 702}, two_goals()));

  ASSERT_EQ(desk.of<MissionDecided>().size(), 1U);
  EXPECT_TRUE(desk.of<MissionDecided>()[0].outcome.planned);
  EXPECT_THAT(desk.goals(), ElementsAre("701 planned", "702 planned"));
  EXPECT_THAT(desk.requests(), ElementsAre("START 100", "START 101"));
  EXPECT_THAT(desk.decisions(), ElementsAre("3 refine", "1 insert: tour", "5 execute"));
  ASSERT_EQ(desk.of<PlanChanged>().size(), 1U);
  EXPECT_EQ(desk.supervisor.report().tasks.size(), 3U);
  EXPECT_TRUE(desk.supervisor.report().tasks[1].committed);
  EXPECT_FALSE(desk.supervisor.report().tasks[2].committed);
}

TEST(SupervisorMission, IsGivenGoalByGoalAtTheHorizonAndAchievedWhenAllHasEnded) {
  Desk desk = with_two_goals();
  desk.runs(100);
  EXPECT_EQ(desk.state_of(701), "under-way");
  desk.at(10).ends(100);
  desk.runs(101);
  EXPECT_EQ(desk.supervisor.next_wakeup(), at(95));

  desk.at(94).give(Tick{});
  EXPECT_THAT(desk.requests(), IsEmpty());
  desk.at(95).give(Tick{});
  EXPECT_THAT(desk.requests(), ElementsAre("START 102"));

  desk.at(115).ends(101);
  EXPECT_THAT(desk.goals(), ElementsAre("701 achieved"));
  desk.runs(102);
  desk.at(130).ends(102);
  EXPECT_EQ(desk.state_of(702), "achieved");
  EXPECT_THAT(desk.supervisor.report().tasks, IsEmpty());
}

// ---- what may begin much later ----

Desk with_a_goal_for_later(const Config& config = config_for_tests()) {
  Desk desk = Desk::engaged(config);
  desk.add(a_mission(1, {701, 702}));
  desk.finish(inserted({701, 702}, {TaskOf(100, "takeoff", 701),
                                    TaskOf(101, "goto", 702).after(100).starts_after(500)}));
  desk.runs(100);
  desk.at(12).ends(100);
  return desk;
}

TEST(SupervisorLater, InTheAirItIsWaitedForInSafeModeAndNamed) {
  const Desk desk = with_a_goal_for_later();

  EXPECT_THAT(desk.requests(), ElementsAre("START 102"));
  EXPECT_THAT(desk.notices(),
              ElementsAre("in the air with nothing to do: waits in safe mode, task 102; goal 702 "
                          "(go 1) waits: nothing of it may begin before 500 s"));
}

TEST(SupervisorLater, ItIsGivenWhenItMayBeginAndTheSafeWaitEndsInTimeForIt) {
  Desk desk = with_a_goal_for_later();
  EXPECT_EQ(desk.supervisor.next_wakeup(), at(499));
  desk.at(498).give(Tick{});
  EXPECT_THAT(desk.requests(), IsEmpty());

  desk.at(499).give(Tick{});

  EXPECT_THAT(desk.requests(), ElementsAre("START 101", "ABORT 102"));
}

TEST(SupervisorLater, AMissionThatComesMeanwhileMayGoBeforeIt) {
  Desk desk = with_a_goal_for_later();

  desk.at(60).add(a_mission(2, {801}));

  ASSERT_EQ(desk.insertion().planned.size(), 1U);
  EXPECT_EQ(desk.insertion().planned[0].id, GoalId{702});
}

TEST(SupervisorLater, OnTheGroundItIsGivenAtTheHorizonAndNothingWaits) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "takeoff", 701).starts_after(500)}));
  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_EQ(desk.supervisor.next_wakeup(), at(485));

  desk.at(485).give(Tick{});

  EXPECT_THAT(desk.requests(), ElementsAre("START 100"));
}

// It was given with what comes before it; then the UAV has nothing to do until its time.
TEST(SupervisorLater, WhatTheExecutiveHasAlreadyIsWaitedForInTheSameWay) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted(
      {701}, {TaskOf(100, "takeoff", 701), TaskOf(101, "goto", 701).after(100).starts_after(500)}));
  EXPECT_THAT(desk.requests(), ElementsAre("START 100", "START 101"));
  desk.runs(100);

  desk.at(12).ends(100);
  EXPECT_THAT(desk.requests(), ElementsAre("START 102", "UPDATE 101"));
  EXPECT_THAT(desk.notices(), Contains(HasSubstr("goal 701 (go 1) waits: nothing of it may begin "
                                                 "before 500 s")));
  EXPECT_EQ(desk.supervisor.next_wakeup(), at(499));
  desk.at(499).give(Tick{});

  EXPECT_THAT(desk.requests(), ElementsAre("ABORT 102"));
  EXPECT_THAT(desk.notices(), IsEmpty());
}

TEST(SupervisorLater, WhatBeginsWithinTheHorizonIsHeldWithoutASafeWaitAndNamed) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701, 702}));
  desk.finish(inserted({701, 702}, {TaskOf(100, "takeoff", 701),
                                    TaskOf(101, "goto", 702).after(100).starts_after(24)}));
  desk.runs(100);

  desk.at(12).ends(100);

  EXPECT_THAT(desk.requests(), ElementsAre("START 101"));
  EXPECT_THAT(desk.notices(), ElementsAre("in the air without a task for a moment: goal 702 (go 1) "
                                          "waits: nothing of it may begin before 24 s"));
  desk.at(15).give(Tick{});
  EXPECT_THAT(desk.notices(), IsEmpty());
}

TEST(SupervisorLater, ForAPilotTheSafeWaitEndsEarlierByHisReaction) {
  Config config = config_for_tests();
  auto knowledge = std::make_shared<Knowledge>(*config.knowledge);
  knowledge->vehicle.pilot.emplace();
  knowledge->vehicle.pilot->reaction = secs(2);
  knowledge->vehicle.pilot->reaction_spread = secs(0.5);
  config.knowledge = knowledge;
  Desk desk = with_a_goal_for_later(config);

  EXPECT_EQ(desk.supervisor.next_wakeup(), at(500 - 1 - 2 - 3 * 0.5));
}

TEST(SupervisorLater, WhoTakesOverFindsNoSafeWaitInTheWay) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted(
      {701}, {TaskOf(100, "takeoff", 701), TaskOf(101, "goto", 701).after(100).starts_after(500)}));
  desk.runs(100);
  desk.at(12).ends(100);

  desk.at(20).give(Disengage{"degree 3"});

  EXPECT_THAT(desk.requests(), ElementsAre("ABORT 102"));
}

// ---- refusals ----

TEST(SupervisorMission, RefusedLeavesThePlanAsItIs) {
  Desk desk = with_two_goals();
  const auto before = desk.supervisor.report().tasks;
  desk.add(a_mission(2, {703}));

  desk.finish(refused("no way to 703"));

  ASSERT_EQ(desk.of<MissionDecided>().size(), 1U);
  EXPECT_FALSE(desk.of<MissionDecided>()[0].outcome.planned);
  EXPECT_THAT(desk.of<MissionDecided>()[0].outcome.reasons, ElementsAre("no way to 703"));
  EXPECT_THAT(desk.goals(), ElementsAre("703 failed"));
  EXPECT_EQ(desk.supervisor.report().tasks, before);
  EXPECT_THAT(desk.requests(), IsEmpty());
}

TEST(SupervisorMission, ThatComesWhileAJobRunsWaitsForItsTurn) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.add(a_mission(2, {702}));
  EXPECT_FALSE(desk.job_started());

  desk.finish(inserted({701}, {TaskOf(100, "takeoff", 701)}));

  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.insertion().added[0].id, GoalId{702});
  EXPECT_EQ(desk.insertion().standing.tasks.size(), 1U);
  EXPECT_EQ(desk.insertion().base.situation.next_id, TaskId{101});
}

TEST(SupervisorMission, MayMoveWhatIsPlannedButNotWhatTheExecutiveHas) {
  Desk desk = with_two_goals();

  desk.add(a_mission(2, {703}));

  ASSERT_EQ(desk.insertion().planned.size(), 1U);
  EXPECT_EQ(desk.insertion().planned[0].id, GoalId{702});
  EXPECT_EQ(desk.insertion().standing.tasks.size(), 2U);

  desk.finish(inserted({703, 702},
                       {TaskOf(103, "goto", 703).after(101), TaskOf(104, "goto", 702).after(103)}));
  std::vector<TaskId> ids;
  for (const auto& one : desk.supervisor.report().tasks) ids.push_back(one.task.id);
  EXPECT_THAT(ids, ElementsAre(TaskId{100}, TaskId{101}, TaskId{103}, TaskId{104}));
}

TEST(SupervisorMission, IsPlannedFromWhereWhatIsInHandEnds) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted(
      {701}, {TaskOf(100, "takeoff", 701).takes(4, 6),
              TaskOf(101, "goto", 701).after(100).energy(0.2).way({{0, 0, 40}, {0, 300, 50}})}));
  desk.runs(100);

  desk.at(2).add(a_mission(2, {702}));

  const Situation& there = desk.insertion().base.situation;
  EXPECT_EQ(there.position, world::Vector3(0, 300, 50));
  EXPECT_TRUE(there.airborne);
  EXPECT_NEAR(there.heading, 1.5708, 1e-3);
  EXPECT_NEAR(there.energy, 0.8, 1e-9);
  EXPECT_EQ(there.origin, at(2));
  ASSERT_TRUE(there.motion.after.has_value());
  EXPECT_EQ(*there.motion.after,
            (mission::Dependence{mission::DependenceKind::kEnded, TaskId{101}}));
  EXPECT_EQ(there.motion.free, (mission::Interval{secs(12), secs(24)}));
}

TEST(SupervisorMission, IsPlannedAgainWhenItsPremisesChanged) {
  Desk desk = with_two_goals();
  desk.runs(100);
  desk.add(a_mission(2, {703}));
  const std::uint64_t first = desk.job_id;
  desk.at(5).aborted(100);

  desk.finish(inserted({703, 702}, {TaskOf(103, "goto", 703), TaskOf(104, "goto", 702)}));

  EXPECT_NE(desk.job_id, first);
  EXPECT_TRUE(std::holds_alternative<RepairRequest>(*desk.request));
  EXPECT_EQ(desk.state_of(703), "received");
  EXPECT_FALSE(desk.started(103).has_value());
}

TEST(SupervisorMission, ThatIsPlannedAgainManyTimesIsNoted) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  Words said;
  for (int i = 0; i < 6; ++i) {
    mission::ChangeWorld change;
    change.volume = {"v" + std::to_string(i), {{0, 0}, {1, 0}, {0, 1}}, 0, 10, {}};
    desk.give(WorldChanged{change});
    desk.finish(inserted({701}, {TaskOf(100, "takeoff", 701)}));
    said = desk.notices();
  }

  EXPECT_THAT(said, Contains(HasSubstr("again for the 6th time")));
  EXPECT_EQ(desk.state_of(701), "received");
}

TEST(SupervisorMission, ResultThatNobodyWaitsForChangesNothing) {
  Desk desk = with_two_goals();

  desk.give(JobFinished{77, inserted({702}, {})});

  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_THAT(desk.notices(), Contains(HasSubstr("nobody waits for")));
}

TEST(SupervisorMission, PlanWithAnIdThatWasUsedIsRefused) {
  Desk desk = with_two_goals();
  desk.add(a_mission(2, {703}));

  desk.finish(inserted({703, 702}, {TaskOf(101, "goto", 703), TaskOf(103, "goto", 702)}));

  EXPECT_EQ(desk.state_of(703), "failed");
  EXPECT_EQ(desk.state_of(702), "planned");
}

TEST(SupervisorMission, UrgentInterruptsWhatIsUnderWayOnceItsPlanIsThere) {
  Desk desk = with_two_goals();
  desk.runs(100);
  desk.at(10).ends(100);
  desk.runs(101);
  desk.flies({0, 0, 40});
  mission::UnitMission urgent = a_mission(2, {703});
  urgent.placement = mission::Placement::kFirst;
  urgent.interrupt = true;

  desk.at(20).add(urgent);
  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_THAT(desk.insertion().standing.tasks, IsEmpty());
  EXPECT_EQ(desk.insertion().planned.size(), 2U);
  EXPECT_EQ(desk.insertion().base.situation.motion.after->task, TaskId{101});

  desk.at(21).finish(inserted(
      {703, 701, 702}, {TaskOf(103, "goto", 703).over(101).takes(50, 60),
                        TaskOf(104, "goto", 701).after(103), TaskOf(105, "goto", 702).after(104)}));
  EXPECT_THAT(desk.requests(), ElementsAre("START 103", "ABORT 101"));
  EXPECT_EQ(desk.state_of(701), "under-way");
  desk.aborted_as_asked(101);
  EXPECT_FALSE(desk.job_started());
}

TEST(SupervisorMission, UrgentDoesNotInterruptATakeoff) {
  Desk desk = with_two_goals();
  desk.runs(100);
  mission::UnitMission urgent = a_mission(2, {703});
  urgent.placement = mission::Placement::kFirst;
  urgent.interrupt = true;

  desk.at(2).add(urgent);

  EXPECT_EQ(desk.insertion().standing.tasks.size(), 2U);
}

/// On its way to where it looks at P1, which is seen at (50, 0), with a head that it can aim.
Desk watching(const world::Vector3& from = {0, 0, 60}) {
  Config config = config_for_tests();
  auto knowledge = std::make_shared<Knowledge>(*config.knowledge);
  knowledge->vocabulary.tasks["watch"] = {"watch", {mission::ParameterKind::kPlace}, {}};
  knowledge->vehicle.sensors.front().gimballed = true;
  knowledge->vehicle.sensors.front().aperture = 0.4;
  config.knowledge = knowledge;
  auto world = std::make_shared<world::World>(*config.world);
  world->places["P1"] = {50, 0, 0};
  config.world = world;
  Desk desk = Desk::engaged(std::move(config));
  mission::UnitMission mission = a_mission(1, {701});
  mission.tasks[0].name = "watch";
  mission.tasks[0].arguments = {std::string("P1")};
  desk.add(mission);
  InsertionOutcome outcome = inserted(
      {701},
      {TaskOf(100, "goto", 701).way({{0, 0, 60}, from}).takes(100, 120),
       TaskOf(101, "perceive", 701).device("camera").target({50, 0, 0}).after(100).takes(60, 60)});
  outcome.order = mission.tasks;
  desk.finish(std::move(outcome));
  desk.runs(100);
  return desk;
}
bool is_planned_again(Desk& desk, double x) {
  mission::ChangeWorld change;
  change.place = mission::KnownPlace{"P1", {x, 0, 0}, 0, std::nullopt};
  desk.give(WorldChanged{change});
  return desk.job_started();
}

// What it is about moves 10 m at a time, as a fire front does.
TEST(SupervisorMission, UnderWayIsPlannedAgainOnceItsPlaceHasLeftTheView) {
  Desk desk = watching();

  EXPECT_FALSE(is_planned_again(desk, 60));
  EXPECT_TRUE(is_planned_again(desk, 70));
}

// 10 m to the side are half a radian from 18 m away.
TEST(SupervisorMission, UnderWayFromNearByIsPlannedAgainForWhatIsNothingFromAfar) {
  Desk near_by = watching({32, 0, 0}), afar = watching({-50, 0, 0});
  mission::ChangeWorld aside;
  aside.place = mission::KnownPlace{"P1", {50, 10, 0}, 0, std::nullopt};

  near_by.give(WorldChanged{aside});
  afar.give(WorldChanged{aside});

  EXPECT_TRUE(near_by.job_started());
  EXPECT_FALSE(afar.job_started());
}

TEST(SupervisorMission, UnderWayGoesOnWhileItsPlaceMovesToAndFro) {
  Desk desk = watching();

  for (const double x : {60, 50, 60, 50, 40}) EXPECT_FALSE(is_planned_again(desk, x)) << x;
}

}  // namespace
}  // namespace skein::supervisor
