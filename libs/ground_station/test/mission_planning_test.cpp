// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/mission_planning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using executive::TaskState;
using mission::GoalId;
using mission::GoalState;
using mission::MissionId;
using testing::a_step;
using testing::a_task;
using testing::at;
using ::testing::ElementsAre;
using testing::first;
using testing::flat_terrain;
using testing::id;
using ::testing::IsEmpty;
using testing::only;
using ::testing::SizeIs;
using Effects = std::vector<MissionPlanning::Effect>;

Trigger when(decltype(Trigger::what) what) { return {std::move(what)}; }

Trigger task_is(std::uint64_t task, TaskState state) { return {OnTask{"marvin", id(task), state}}; }

TaskChanged changed(std::uint64_t task, TaskState state) { return {"marvin", id(task), state}; }

MissionPlanning playing(std::vector<Step> steps, std::vector<OperatorAction> operators = {}) {
  return {Script{std::move(steps), std::move(operators), Duration::seconds(60)}, flat_terrain()};
}

AlarmEvent alarm(std::uint32_t number, AlarmState state, double x = 0) {
  Alarm out;
  out.id = AlarmId(number);
  out.state = state;
  out.position = {x, 0, 0};
  return {out};
}

CommandChanged of_step(const std::string& step, CommandState state) {
  return {CommandNumber(1), "marvin", "DEGREE 1", state, "", asked_by_step(step)};
}

std::vector<std::string> steps_done(const Effects& effects) {
  std::vector<std::string> names;
  for (const StepDone& step : only<StepDone>(effects)) names.push_back(step.name);
  return names;
}

// ---- triggers ----

TEST(MissionPlanning, AnInstantIsWokenUpForAndKept) {
  MissionPlanning mps =
      playing({a_step("late", when(AtTime{at(20)})), a_step("go", when(AtTime{at(10)}))});

  EXPECT_EQ(mps.next_wakeup(), at(10));
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(9.999))), IsEmpty());
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(10))), ElementsAre("go"));
  EXPECT_EQ(mps.next_wakeup(), at(20));
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(25))), ElementsAre("late"));
  EXPECT_EQ(mps.next_wakeup(), std::nullopt);
}

TEST(MissionPlanning, EachKindOfEventFiresItsTrigger) {
  struct Case {
    Trigger trigger;
    MissionPlanning::Input near_miss;
    MissionPlanning::Input hit;
  };
  const std::vector<Case> table = {
      {when(OnAlarm{AlarmState::kConfirmed}), alarm(1, AlarmState::kRaised),
       alarm(1, AlarmState::kConfirmed)},
      {when(OnAlarm{AlarmState::kRaised, AlarmId(2)}), alarm(1, AlarmState::kRaised),
       alarm(2, AlarmState::kRaised)},
      {when(OnAlarm{AlarmState::kInfirmed, AlarmId(2)}), alarm(1, AlarmState::kInfirmed),
       alarm(2, AlarmState::kInfirmed)},
      {task_is(2, TaskState::kRunning), changed(2, TaskState::kEnded),
       changed(2, TaskState::kRunning)},
      {task_is(2, TaskState::kRunning), TaskChanged{"heliv", id(2), TaskState::kRunning},
       changed(2, TaskState::kRunning)},
      {when(OnOperator{"stop"}), OperatorActs{"halt"}, OperatorActs{"stop"}},
      {when(OnRestart{"marvin"}), UavRestarted{"heliv", {}}, UavRestarted{"marvin", {}}},
      {when(OnExpired{"it"}), of_step("other", CommandState::kExpired),
       of_step("it", CommandState::kExpired)},
      {when(OnExpired{"it"}), of_step("it", CommandState::kRefused),
       of_step("it", CommandState::kExpired)},
      {when(OnHeld{"marvin"}), PlanInterrupted{"heliv"}, PlanInterrupted{"marvin"}},
      {when(OnDegree{"marvin", 1}), DegreeChanged{"marvin", 3}, DegreeChanged{"marvin", 1}},
      {when(OnGoal{"marvin", GoalId(701), GoalState::kAchieved}),
       GoalChanged{"marvin", GoalId(701), GoalState::kFailed},
       GoalChanged{"marvin", GoalId(701), GoalState::kAchieved}},
      {when(OnMission{"marvin", MissionId(2), MissionStage::kPlanned}),
       MissionChanged{"marvin", MissionId(3), MissionStage::kPlanned},
       MissionChanged{"marvin", MissionId(2), MissionStage::kPlanned}},
  };

  for (std::size_t i = 0; i < table.size(); ++i) {
    MissionPlanning mps = playing({a_step("it", table[i].trigger)});

    EXPECT_THAT(steps_done(mps.handle(table[i].near_miss, at(1))), IsEmpty()) << "case " << i;
    EXPECT_THAT(steps_done(mps.handle(table[i].hit, at(2))), ElementsAre("it")) << "case " << i;
    EXPECT_THAT(steps_done(mps.handle(table[i].hit, at(3))), IsEmpty()) << "once, case " << i;
  }
}

TEST(MissionPlanning, AllWaitsForAllInAnyOrder) {
  MissionPlanning mps = playing({a_step(
      "both", when(AllOf{{task_is(1, TaskState::kEnded), task_is(2, TaskState::kEnded)}}))});

  EXPECT_THAT(steps_done(mps.handle(changed(2, TaskState::kEnded), at(1))), IsEmpty());
  EXPECT_THAT(steps_done(mps.handle(changed(1, TaskState::kEnded), at(2))), ElementsAre("both"));
}

TEST(MissionPlanning, AnyWaitsForTheFirst) {
  MissionPlanning mps = playing(
      {a_step("either", when(AnyOf{{task_is(1, TaskState::kEnded), when(AtTime{at(50)})}}))});

  EXPECT_EQ(mps.next_wakeup(), at(50));
  EXPECT_THAT(steps_done(mps.handle(changed(1, TaskState::kEnded), at(1))), ElementsAre("either"));
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(50))), IsEmpty());
}

TEST(MissionPlanning, TriggersNest) {
  const Trigger one_of_two =
      when(AnyOf{{task_is(1, TaskState::kEnded), task_is(2, TaskState::kEnded)}});
  MissionPlanning mps =
      playing({a_step("nested", when(AllOf{{when(AtTime{at(10)}), one_of_two}}))});

  EXPECT_THAT(steps_done(mps.handle(changed(2, TaskState::kEnded), at(5))), IsEmpty());
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(10))), ElementsAre("nested"));
}

TEST(MissionPlanning, StepsFollowOneAnotherInOneCall) {
  MissionPlanning mps =
      playing({a_step("third", when(OnStep{"second"})), a_step("first", when(AtTime{at(1)})),
               a_step("second", when(OnStep{"first"}))});

  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(1))), ElementsAre("first", "second", "third"));
}

TEST(MissionPlanning, TheDelayRunsFromTheTrigger) {
  Step step = a_step("later", task_is(1, TaskState::kEnded));
  step.after = Duration::seconds(5);
  MissionPlanning mps = playing({step});

  EXPECT_THAT(steps_done(mps.handle(changed(1, TaskState::kEnded), at(10))), IsEmpty());
  EXPECT_EQ(mps.next_wakeup(), at(15));
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(15))), ElementsAre("later"));
}

TEST(MissionPlanning, WhatIsDueGoesInOrderOfItsInstant) {
  MissionPlanning mps =
      playing({a_step("b", when(AtTime{at(20)})), a_step("a", when(AtTime{at(10)})),
               a_step("c", when(AtTime{at(20)}))});

  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(30))), ElementsAre("a", "b", "c"));
}

TEST(MissionPlanning, ARepeatingStepIsArmedAgainButNotWithinASecond) {
  Step step = a_step("again", when(OnOperator{"photo"}));
  step.once = false;
  MissionPlanning mps = playing({step});

  EXPECT_THAT(steps_done(mps.handle(OperatorActs{"photo"}, at(1))), SizeIs(1));
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(9))), IsEmpty());
  EXPECT_THAT(steps_done(mps.handle(OperatorActs{"photo"}, at(10))), SizeIs(1));
  EXPECT_THAT(steps_done(mps.handle(OperatorActs{"photo"}, at(10.5))), IsEmpty());
  EXPECT_EQ(mps.next_wakeup(), at(11));
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(11))), SizeIs(1));
}

TEST(MissionPlanning, AnInstantIsNoReasonToRepeat) {
  Step step = a_step("again", when(AllOf{{when(AtTime{at(5)}), when(OnOperator{"photo"})}}));
  step.once = false;
  MissionPlanning mps = playing({step});

  EXPECT_THAT(steps_done(mps.handle(OperatorActs{"photo"}, at(1))), IsEmpty());
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(5))), SizeIs(1));
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(50))), IsEmpty());
  EXPECT_THAT(steps_done(mps.handle(OperatorActs{"photo"}, at(60))), SizeIs(1));
}

TEST(MissionPlanning, StepsThatWaitForEachOtherDoNotSpin) {
  Step ping = a_step("ping", when(AnyOf{{when(AtTime{at(1)}), when(OnStep{"pong"})}}));
  Step pong = a_step("pong", when(OnStep{"ping"}));
  ping.once = pong.once = false;
  MissionPlanning mps = playing({ping, pong});

  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(1))), ElementsAre("ping", "pong"));
  EXPECT_EQ(mps.next_wakeup(), at(2));
}

// ---- actions ----

TEST(MissionPlanning, APlanIsSentInOrderWithItsModes) {
  SendPlan plan{"marvin",
                {{a_task(1, "takeoff"), executive::InsertionMode::kVut, {}},
                 {a_task(2), executive::InsertionMode::kDep, {}}}};
  MissionPlanning mps = playing({a_step("go", when(AtTime{at(1)}), {plan})});

  const auto issued = only<IssueCommand>(mps.handle(Tick{}, at(1)));

  ASSERT_THAT(issued, SizeIs(2));
  EXPECT_EQ(issued[0].uav, "marvin");
  EXPECT_EQ(issued[0].expires, at(61));
  const auto& second = std::get<executive::Start>(issued[1].request);
  EXPECT_EQ(second.task.id, id(2));
  EXPECT_EQ(second.mode, executive::InsertionMode::kDep);
}

TEST(MissionPlanning, TheOtherActionsBecomeTheirRequests) {
  const executive::UpdateConditions update{id(4), {}, {{testing::in_state(1, TaskState::kEnded)}}};
  MissionPlanning mps =
      playing({a_step("all", when(AtTime{at(1)}),
                      {AbortTasks{"marvin", {{id(3), id(2)}}}, AbortTasks{"heliv", std::nullopt},
                       SendMessage{"marvin", "go"}, UpdateConditions{"marvin", update}})});

  const Effects effects = mps.handle(Tick{}, at(1));

  const auto issued = only<IssueCommand>(effects);
  ASSERT_THAT(issued, SizeIs(4));
  EXPECT_EQ(std::get<executive::Abort>(issued[0].request).id, id(3));
  EXPECT_EQ(std::get<executive::Abort>(issued[1].request).id, id(2));
  EXPECT_EQ(std::get<executive::ProcessMessage>(issued[2].request).message, "go");
  EXPECT_EQ(std::get<executive::UpdateConditions>(issued[3].request).id, id(4));
  EXPECT_EQ(first<AbortEverything>(effects).uav, "heliv");
}

world::Volume tower() {
  world::Volume out;
  out.name = "tower";
  out.polygon = {{0, 0}, {10, 0}, {0, 10}};
  return out;
}

TEST(MissionPlanning, ActionsOnAutonomyBecomeRequests) {
  mission::CancelGoals cancel;
  cancel.goals = {GoalId(701)};
  MissionPlanning mps =
      playing({a_step("all", when(AtTime{at(1)}),
                      {CancelMission{"marvin", cancel}, SetDegree{"marvin", {3, true, false}},
                       CloseAir{tower(), {"marvin"}}, OpenAir{"tower", {"marvin"}}})});

  const auto issued = only<IssueCommand>(mps.handle(Tick{}, at(1)));

  ASSERT_THAT(issued, SizeIs(4));
  EXPECT_EQ(std::get<mission::CancelGoals>(issued[0].request), cancel);
  EXPECT_EQ(std::get<mission::ChangeDegree>(issued[1].request),
            (mission::ChangeDegree{3, true, false}));
  EXPECT_EQ(std::get<mission::ChangeWorld>(issued[2].request).volume, tower());
  EXPECT_TRUE(std::get<mission::ChangeWorld>(issued[3].request).remove);
  EXPECT_EQ(issued[3].asked_by, "step all");
}

TEST(MissionPlanning, WhatIsKnownOfTheWorldIsToldToThoseMeant) {
  mission::ChangeWorld place;
  place.place = {"well", {1, 2, 3}, 0, std::nullopt};
  MissionPlanning mps = playing(
      {a_step("all", when(AtTime{at(1)}), {TellWorld{place, {"marvin"}}, TellWorld{place}})});

  const Effects effects = mps.handle(Tick{}, at(1));

  const auto issued = only<IssueCommand>(effects);
  ASSERT_THAT(issued, SizeIs(1));
  EXPECT_EQ(issued[0].uav, "marvin");
  EXPECT_EQ(std::get<mission::ChangeWorld>(issued[0].request), place);
  EXPECT_THAT(only<IssueToAll>(effects), SizeIs(1));
}

TEST(MissionPlanning, ActionsOnHandsAndAirGoToTheOthers) {
  MissionPlanning mps =
      playing({}, {{"operator",
                    when(AtTime{at(1)}),
                    Duration(),
                    {TakeInHand{"marvin", true}, GiveBack{"marvin"}, ResumePlan{"marvin", {id(4)}},
                     DropPlan{"marvin"}, CloseAir{tower()}, OpenAir{"tower"}}}});

  const Effects effects = mps.handle(Tick{}, at(1));

  const auto hands = only<ChangeHands>(effects);
  ASSERT_THAT(hands, SizeIs(2));
  EXPECT_EQ(hands[0].way, ChangeHands::Way::kTake);
  EXPECT_TRUE(hands[0].interrupt);
  EXPECT_EQ(hands[0].asked_by, "operator operator");
  EXPECT_EQ(hands[1].way, ChangeHands::Way::kGiveBack);
  EXPECT_THAT(first<ResumeHeld>(effects).without, ElementsAre(id(4)));
  EXPECT_EQ(first<DropHeld>(effects).uav, "marvin");
  EXPECT_THAT(only<IssueToAll>(effects), SizeIs(2));
}

TEST(MissionPlanning, PhasesAreEnteredOnce) {
  Step one = a_step("one", when(AtTime{at(1)}));
  Step two = a_step("two", when(AtTime{at(2)}));
  Step three = a_step("three", when(AtTime{at(3)}));
  one.phase = two.phase = "Detection";
  MissionPlanning mps = playing({one, two, three});

  const Effects effects = mps.handle(Tick{}, at(3));

  EXPECT_THAT(only<PhaseEntered>(effects), SizeIs(1));
  EXPECT_EQ(mps.phase(), "Detection");
}

TEST(MissionPlanning, FinishEndsEverything) {
  MissionPlanning mps =
      playing({a_step("end", when(AtTime{at(1)}), {Finish{}, SendMessage{"marvin", "no"}}),
               a_step("later", when(AtTime{at(2)}))});

  const Effects effects = mps.handle(Tick{}, at(1));

  EXPECT_THAT(only<MissionFinished>(effects), SizeIs(1));
  EXPECT_THAT(only<IssueCommand>(effects), IsEmpty());
  EXPECT_THAT(only<StepDone>(effects), SizeIs(1)) << "the step that ends it is one, too";
  EXPECT_TRUE(mps.finished());
  EXPECT_EQ(mps.next_wakeup(), std::nullopt);
  EXPECT_THAT(mps.handle(Tick{}, at(5)), IsEmpty());
}

// ---- operators ----

TEST(MissionPlanning, AScriptedOperatorActsAndTheStepsFollow) {
  MissionPlanning mps =
      playing({a_step("home", when(OnOperator{"end-monitoring"}))},
              {{"end-monitoring", task_is(1, TaskState::kRunning), Duration::seconds(30), {}}});
  mps.handle(changed(1, TaskState::kRunning), at(10));

  const Effects effects = mps.handle(Tick{}, at(40));

  EXPECT_EQ(first<OperatorDid>(effects).does, "end-monitoring");
  EXPECT_THAT(steps_done(effects), ElementsAre("home"));
}

TEST(MissionPlanning, AnOperatorsOwnActionsAreDone) {
  MissionPlanning mps = playing(
      {}, {{"abort", when(AtTime{at(1)}), Duration(), {AbortTasks{"marvin", std::nullopt}}}});

  EXPECT_THAT(only<AbortEverything>(mps.handle(Tick{}, at(1))), SizeIs(1));
}

TEST(MissionPlanning, ALiveOperatorCountsAsAScriptedOne) {
  MissionPlanning mps = playing({a_step("home", when(OnOperator{"stop"}))});

  const Effects effects = mps.handle(OperatorActs{"stop"}, at(1));

  EXPECT_THAT(only<OperatorDid>(effects), SizeIs(1));
  EXPECT_THAT(steps_done(effects), ElementsAre("home"));
}

// ---- the subject alarm ----

std::vector<double> where_sent(const Effects& effects) {
  const auto issued = only<IssueCommand>(effects);
  if (issued.empty()) return {};
  return std::get<executive::Start>(issued[0].request).task.parameters.find("to")->numbers;
}

Action go_to_alarm(std::uint64_t task) {
  return SendPlan{"marvin", {{a_task(task), executive::InsertionMode::kSeq, {{TheAlarm{}, "to"}}}}};
}

TEST(MissionPlanning, TargetsAreAboutTheAlarmOfTheStep) {
  MissionPlanning mps =
      playing({a_step("look", when(OnAlarm{AlarmState::kRaised}), {go_to_alarm(1)}),
               a_step("again", when(OnOperator{"again"}), {go_to_alarm(2)})});

  EXPECT_THAT(where_sent(mps.handle(alarm(1, AlarmState::kRaised, 100), at(1))),
              ElementsAre(100, 0, 0));
  mps.handle(alarm(2, AlarmState::kRaised, 500), at(2));
  mps.handle(AlarmRefined{alarm(1, AlarmState::kRaised, 120).alarm}, at(3));

  EXPECT_THAT(where_sent(mps.handle(OperatorActs{"again"}, at(4))), ElementsAre(120, 0, 0))
      << "the latest estimate of the alarm that a step was about";
}

TEST(MissionPlanning, AConfirmedAlarmBecomesTheSubject) {
  MissionPlanning mps =
      playing({a_step("look", when(OnAlarm{AlarmState::kRaised})),
               a_step("watch", when(OnAlarm{AlarmState::kConfirmed}), {go_to_alarm(1)})});
  mps.handle(alarm(1, AlarmState::kRaised, 100), at(1));
  mps.handle(alarm(2, AlarmState::kRaised, 500), at(2));

  EXPECT_THAT(where_sent(mps.handle(alarm(2, AlarmState::kConfirmed, 510), at(3))),
              ElementsAre(510, 0, 0));
}

TEST(MissionPlanning, OnlyTheSubjectsInfirmationCounts) {
  MissionPlanning mps = playing({a_step("look", when(OnAlarm{AlarmState::kRaised})),
                                 a_step("back", when(OnAlarm{AlarmState::kInfirmed}))});
  mps.handle(alarm(1, AlarmState::kRaised), at(1));
  mps.handle(alarm(2, AlarmState::kRaised), at(2));

  EXPECT_THAT(steps_done(mps.handle(alarm(2, AlarmState::kInfirmed), at(3))), IsEmpty());
  EXPECT_THAT(steps_done(mps.handle(alarm(1, AlarmState::kInfirmed), at(4))), ElementsAre("back"));
}

TEST(MissionPlanning, ATaskWhoseTargetIsUnknownIsNotSent) {
  MissionPlanning mps = playing({a_step("early", when(AtTime{at(1)}), {go_to_alarm(7)})});

  const Effects effects = mps.handle(Tick{}, at(1));

  EXPECT_THAT(only<IssueCommand>(effects), IsEmpty());
  EXPECT_EQ(first<Anomaly>(effects).why, "task 7 of marvin is not sent: there is no alarm");
}

SendMission watch_alarm() {
  mission::UnitMission mission;
  mission.id = MissionId(2);
  const world::Vector3 nowhere = world::Vector3::Zero();
  mission.tasks = {{GoalId(701), "goto", {nowhere}, {}},
                   {GoalId(702), "shot", {20.0, nowhere}, {}}};
  return {"marvin", mission, {{0, 0, NearAlarm{0, 50, 40}}, {1, 1, TheAlarm{}}}};
}

TEST(MissionPlanning, AMissionIsAboutTheAlarmWhenItIsSent) {
  MissionPlanning mps =
      playing({a_step("watch", when(OnAlarm{AlarmState::kRaised}), {watch_alarm()})});

  const auto issued = first<IssueCommand>(mps.handle(alarm(1, AlarmState::kRaised, 100), at(1)));

  const auto& mission = std::get<mission::UnitMission>(issued.request);
  EXPECT_EQ(mission.asked_by, "step watch");
  EXPECT_EQ(std::get<world::Vector3>(mission.tasks[0].arguments[0]), world::Vector3(150, 0, 40));
  EXPECT_EQ(std::get<double>(mission.tasks[1].arguments[0]), 20);
  EXPECT_EQ(std::get<world::Vector3>(mission.tasks[1].arguments[1]), world::Vector3(100, 0, 0));
}

TEST(MissionPlanning, AMissionWhoseTargetIsUnknownIsNotSent) {
  SendMission misplaced = watch_alarm();
  misplaced.targets = {{5, 0, TheAlarm{}}};
  MissionPlanning mps = playing({a_step("early", when(AtTime{at(1)}), {watch_alarm()}),
                                 a_step("wrong", when(OnAlarm{AlarmState::kRaised}), {misplaced})});

  const Effects early = mps.handle(Tick{}, at(1));
  const Effects wrong = mps.handle(alarm(1, AlarmState::kRaised), at(2));

  EXPECT_THAT(only<IssueCommand>(early), IsEmpty());
  EXPECT_EQ(first<Anomaly>(early).why,
            "mission 2 of marvin is not sent: there is no alarm to be near to");
  EXPECT_EQ(first<Anomaly>(wrong).why,
            "mission 2 of marvin is not sent: a target is for no argument");
}

TEST(MissionPlanning, WhatExpiresIsAskedAgainAsOftenAsItExpires) {
  Step asks = a_step("asks", when(AnyOf{{when(AtTime{at(5)}), when(OnExpired{"asks"})}}));
  asks.once = false;
  MissionPlanning mps = playing({asks});
  const CommandChanged expired = of_step("asks", CommandState::kExpired);

  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(5))), ElementsAre("asks"));
  EXPECT_THAT(steps_done(mps.handle(Tick{}, at(50))), IsEmpty()) << "the instant alone is no cause";
  EXPECT_THAT(steps_done(mps.handle(expired, at(65))), ElementsAre("asks"));
  EXPECT_THAT(steps_done(mps.handle(expired, at(125))), ElementsAre("asks"));
}

}  // namespace
}  // namespace skein::ground_station
