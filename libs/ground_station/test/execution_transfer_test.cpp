// SPDX-License-Identifier: Apache-2.0
// Tasks go from the executive on board to the one at the ground and back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "skein/ground_station/ground_control.hpp"
#include "testing/builders.hpp"
#include "testing/handover_rig.hpp"

namespace skein::ground_station {
namespace {

using executive::Formula;
using executive::TaskState;
using mission::ChangeDegree;
using mission::HeldTask;
using testing::a_task;
using testing::abort_of;
using testing::at;
using ::testing::ElementsAre;
using testing::first;
using testing::flat_terrain;
using testing::HandoverRig;
using ::testing::HasSubstr;
using testing::id;
using testing::in_state;
using ::testing::IsEmpty;
using testing::only;
using ::testing::SizeIs;
using testing::start_of;
using Effects = std::vector<GroundControl::Effect>;

GroundControl control(Degree degree, Script script = {}) {
  GroundConfig config;
  config.uavs = {{"marvin", degree, {}}, {"heliv", 3, {}}};
  config.script = std::move(script);
  return {config, flat_terrain()};
}

OperatorCommand command(Request request) {
  return {"marvin", std::move(request), Duration::seconds(60)};
}

HeldTask held(std::uint64_t task, TaskState state, bool in_executive, Formula preconditions = {}) {
  HeldTask out;
  out.task = a_task(task);
  out.task.preconditions = std::move(preconditions);
  out.state = state;
  out.in_executive = in_executive;
  return out;
}

/// 5 is running, 6 comes after it, 7 is only planned after 6.
HandOverReceived plan_of_three(int degree, double when = 5) {
  return {"marvin",
          {degree,
           {held(5, TaskState::kRunning, true),
            held(6, TaskState::kScheduled, true, {in_state(5, TaskState::kEnded)}),
            held(7, TaskState::kScheduled, false, {in_state(6, TaskState::kEnded)})},
           {}},
          at(when)};
}

FunctionalStatusReceived status(std::uint64_t task, TaskState state) {
  return {"marvin", {id(task), state, ""}};
}

std::vector<std::string> sent(const Effects& effects) {
  std::vector<std::string> out;
  for (const CommandChanged& change : only<CommandChanged>(effects)) {
    if (change.state == CommandState::kIssued) out.push_back(change.what);
  }
  return out;
}

std::vector<std::uint64_t> dispatched(const Effects& effects) {
  std::vector<std::uint64_t> out;
  for (const SendFunctional& sent : only<SendFunctional>(effects)) {
    const functional::Request& request = sent.request;
    if (request.verb == functional::Verb::kDispatch) out.push_back(request.id.value());
  }
  return out;
}

// ---- down ----

TEST(ExecutionTransfer, GoingToDegreeOneTheGroundGoesOnWithThePlan) {
  GroundControl ground = control(3);

  const Effects taken = ground.handle(plan_of_three(1), at(5));
  const Effects running = ground.handle(status(5, TaskState::kRunning), at(6));
  const Effects ended = ground.handle(status(5, TaskState::kEnded), at(7));

  EXPECT_THAT(dispatched(taken), ElementsAre(5)) << "the functional layer has it and answers";
  EXPECT_THAT(dispatched(running), IsEmpty());
  EXPECT_THAT(dispatched(ended), ElementsAre(6));
  EXPECT_EQ(first<DegreeChanged>(taken).degree, 1);
}

TEST(ExecutionTransfer, CommandsGoToWhoeverHoldsTheTask) {
  GroundControl ground = control(3);
  ground.handle(plan_of_three(1), at(5));

  const Effects of_running = ground.handle(command(abort_of(5)), at(6));
  const Effects of_planned = ground.handle(command(abort_of(7)), at(6));

  EXPECT_EQ(first<SendFunctional>(of_running).request.verb, functional::Verb::kInterrupt);
  EXPECT_THAT(only<SendRequest>(of_planned), IsEmpty());
  EXPECT_EQ(only<CommandChanged>(of_planned).back().state, CommandState::kAcknowledged);
  EXPECT_EQ(first<HeldPlanChanged>(of_planned).state, HeldState::kDropped);
  EXPECT_THAT(ground.board(at(6)).uavs[0].held, IsEmpty());
}

// The UAV's executive knows nothing of them.
TEST(ExecutionTransfer, WhatIsCancelledOnBoardStopsAtTheGround) {
  GroundControl ground = control(3);
  HandOverReceived plan = plan_of_three(1);
  for (const std::size_t of_700 : {0, 2})
    plan.hand_over.tasks[of_700].origin = mission::GoalId(700);
  ground.handle(plan, at(5));
  ground.handle(status(5, TaskState::kRunning), at(6));
  MissionPlanReceived told{"marvin", {}, at(7)};
  told.plan.revision = 1;
  told.plan.goals = {{mission::GoalId(700), mission::MissionId(1), "watch P1",
                      mission::GoalState::kCancelled, "", "step one"}};

  const Effects effects = ground.handle(told, at(7));

  const SendFunctional interrupt = only<SendFunctional>(effects).at(0);
  EXPECT_EQ(interrupt.request.verb, functional::Verb::kInterrupt);
  EXPECT_EQ(interrupt.request.id, id(5));
  EXPECT_THAT(only<SendFunctional>(effects), SizeIs(1)) << "6 is of no cancelled task";
  EXPECT_THAT(ground.board(at(7)).uavs[0].held, IsEmpty()) << "7 was";
}

TEST(ExecutionTransfer, CommandsThatWaitForTheHandOverFindTheTaskAtTheGround) {
  GroundControl ground = control(3);
  ground.handle(command(ChangeDegree{1, false, true}), at(1));
  EXPECT_THAT(only<SendRequest>(ground.handle(command(abort_of(5)), at(2))), IsEmpty());

  const Effects effects = ground.handle(plan_of_three(1), at(5));

  EXPECT_THAT(only<SendRequest>(effects), IsEmpty());
  EXPECT_EQ(only<SendFunctional>(effects).back().request.verb, functional::Verb::kInterrupt);
}

TEST(ExecutionTransfer, StatesThatAreKnownAreNotNewsAgain) {
  GroundControl ground = control(3);
  for (const TaskState state : {TaskState::kScheduled, TaskState::kStarted, TaskState::kRunning}) {
    ground.handle(TaskEventReceived{"marvin", id(5), "goto", state, ""}, at(1));
  }

  const Effects taken = ground.handle(
      HandOverReceived{"marvin", {1, {held(5, TaskState::kRunning, true)}, {}}, at(5)}, at(5));
  const Effects ended = ground.handle(status(5, TaskState::kEnded), at(7));

  EXPECT_THAT(only<LocalTaskEvent>(taken), IsEmpty());
  EXPECT_THAT(only<LocalTaskEvent>(ended), SizeIs(1));
}

TEST(ExecutionTransfer, SynchronisationMessagesThatCameByHereGoWithThePlan) {
  GroundControl ground = control(2);
  ground.handle(SyncReceived{551, "heliv", "marvin"}, at(1));
  HeldTask meet = held(5, TaskState::kRunning, true);
  meet.task.type = "synchronise";
  meet.task.synchronisation = executive::Synchronisation{551, {"heliv"}, {"marvin"}, std::nullopt};

  ground.handle(HandOverReceived{"marvin", {1, {meet}, {}}, at(5)}, at(5));
  const TaskState state = ground.board(at(5)).uavs[0].tasks.find(id(5))->state;
  const Effects up = ground.handle(HandOverReceived{"marvin", {2, {}, {}}, at(6)}, at(6));

  EXPECT_EQ(state, TaskState::kEnded);
  EXPECT_EQ(first<SendSync>(up).id, 551U);
}

TEST(ExecutionTransfer, WhatEndedBeforeTheTransferMayStillBeNamed) {
  GroundControl ground = control(3);
  ground.handle(TaskEventReceived{"marvin", id(4), "goto", TaskState::kEnded, ""}, at(1));
  ground.handle(plan_of_three(1), at(5));
  executive::Start late{a_task(9), executive::InsertionMode::kSeq};
  late.task.preconditions = {in_state(4, TaskState::kEnded)};

  EXPECT_THAT(dispatched(ground.handle(command(late), at(6))), ElementsAre(9));
}

// ---- up ----

/// Task 5 runs, 6 waits for its end.
GroundControl with_two_under_way() {
  GroundControl ground = control(1);
  ground.handle(command(start_of(5)), at(1));
  ground.handle(status(5, TaskState::kRunning), at(2));
  executive::Start next{a_task(6), executive::InsertionMode::kSeq};
  next.task.preconditions = {in_state(5, TaskState::kEnded)};
  ground.handle(command(next), at(2));
  return ground;
}

TEST(ExecutionTransfer, GoingUpTheTasksHereAreSentToTheUav) {
  GroundControl ground = with_two_under_way();

  const Effects effects = ground.handle(HandOverReceived{"marvin", {3, {}, {}}, at(5)}, at(5));

  EXPECT_THAT(sent(effects), ElementsAre("START 5 goto", "START 6 goto"));
  EXPECT_THAT(only<SendFunctional>(effects), IsEmpty()) << "nothing is interrupted";
  EXPECT_THAT(only<SendRequest>(ground.handle(command(abort_of(5)), at(6))), SizeIs(1));
}

TEST(ExecutionTransfer, GoingUpToWhoDeliberatesWhatItAwaitsComesLast) {
  GroundControl ground = with_two_under_way();

  const Effects effects = ground.handle(HandOverReceived{"marvin", {4, {}, {}}, at(5)}, at(5));

  EXPECT_THAT(sent(effects), ElementsAre("START 6 goto", "START 5 goto", "UPDATE-COND 6"));
}

TEST(ExecutionTransfer, WhatANodeThatHasChangedRefusesIsNotLost) {
  GroundControl ground = control(1);
  ground.handle(command(start_of(5)), at(1));
  ground.handle(command(executive::Start{a_task(6), executive::InsertionMode::kDep}), at(1));
  ground.handle(command(ChangeDegree{3, false, true}), at(2));
  EXPECT_THAT(dispatched(ground.handle(status(5, TaskState::kEnded), at(3))), ElementsAre(6));

  const Effects effects = ground.handle(HandOverReceived{"marvin", {3, {}, {}}, at(5)}, at(5));
  ground.handle(status(6, TaskState::kAborted), at(6));

  EXPECT_THAT(sent(effects), ElementsAre("START 6 goto"));
  EXPECT_EQ(ground.board(at(6)).uavs[0].tasks.find(id(6))->state, TaskState::kStarted);
}

// ---- back after minutes ----

TEST(ExecutionTransfer, BackAfterMinutesItHearsTheVehicleBeforeItGivesUpWhatThatHasBegun) {
  executive::Config impatient;
  impatient.functional_timeout = Duration::seconds(120);
  GroundConfig config;
  config.uavs = {{"marvin", 1, impatient}};
  GroundControl ground(config, flat_terrain());
  ground.handle(command(start_of(5)), at(1));

  ground.handle(Resumed{}, at(400));
  ground.handle(status(5, TaskState::kRunning), at(400));

  EXPECT_EQ(ground.board(at(401)).uavs[0].tasks.find(id(5))->state, TaskState::kRunning);
}

// ---- plans that are held ----

TEST(ExecutionTransfer, WhatWasOnlyPlannedIsHeldAndShown) {
  GroundControl ground = control(4);

  const Effects effects = ground.handle(plan_of_three(3), at(5));

  EXPECT_EQ(first<HeldPlanChanged>(effects).state, HeldState::kHeld);
  EXPECT_EQ(first<HeldPlanChanged>(effects).tasks, 1U);
  EXPECT_THAT(ground.board(at(5)).uavs[0].held, SizeIs(1));
  EXPECT_THAT(only<SendFunctional>(effects), IsEmpty()) << "it executes on board";
}

Script script_of(Action action) {
  Script script;
  script.steps = {testing::a_step("it", {OnOperator{"it"}}, {std::move(action)})};
  return script;
}

TEST(ExecutionTransfer, AHeldPlanIsResumedWithoutWhatIsLeftOut) {
  GroundControl ground = control(4, script_of(ResumePlan{"marvin", {id(7)}}));
  HandOverReceived handed = plan_of_three(3);
  handed.hand_over.tasks.push_back(
      held(8, TaskState::kScheduled, false, {in_state(7, TaskState::kEnded)}));
  ground.handle(handed, at(5));
  ground.handle(TaskEventReceived{"marvin", id(6), "goto", TaskState::kScheduled, ""}, at(5));

  const Effects effects = ground.handle(OperatorActs{"it"}, at(6));

  EXPECT_THAT(sent(effects), ElementsAre("START 8 goto"));
  const auto start = std::get<executive::Start>(first<SendRequest>(effects).request);
  EXPECT_EQ(start.task.preconditions, Formula{in_state(6, TaskState::kEnded)});
  const auto changes = only<HeldPlanChanged>(effects);
  ASSERT_THAT(changes, SizeIs(2));
  EXPECT_EQ(changes[0].state, HeldState::kDropped);
  EXPECT_EQ(changes[1].state, HeldState::kResumed);
  EXPECT_THAT(ground.board(at(6)).uavs[0].held, IsEmpty());
}

TEST(ExecutionTransfer, AHeldPlanIsDropped) {
  GroundControl ground = control(4, script_of(DropPlan{"marvin"}));
  ground.handle(plan_of_three(3), at(5));

  const Effects effects = ground.handle(OperatorActs{"it"}, at(6));

  EXPECT_EQ(first<HeldPlanChanged>(effects).state, HeldState::kDropped);
  EXPECT_THAT(only<SendRequest>(effects), IsEmpty()) << "the UAV keeps its high-level tasks";
  EXPECT_THAT(ground.board(at(6)).uavs[0].held, IsEmpty());
}

TEST(ExecutionTransfer, NothingHeldCannotBeResumed) {
  GroundControl ground = control(4, script_of(ResumePlan{"marvin"}));

  EXPECT_THAT(first<Anomaly>(ground.handle(OperatorActs{"it"}, at(6))).why, HasSubstr("'marvin'"));
}

struct BackToFour {
  std::string name;
  std::optional<bool> resume;  ///< as asked; nothing: nobody asked
  std::size_t held_after;
};
class GivenBack : public ::testing::TestWithParam<BackToFour> {};

TEST_P(GivenBack, ThePlanIsTheUavsAgainIfItGoesOn) {
  GroundControl ground = control(4);
  ground.handle(plan_of_three(3), at(5));
  if (GetParam().resume) ground.handle(command(ChangeDegree{4, false, *GetParam().resume}), at(6));

  ground.handle(HandOverReceived{"marvin", {4, {}, {}}, at(7)}, at(7));

  EXPECT_THAT(ground.board(at(7)).uavs[0].held, SizeIs(GetParam().held_after));
}

INSTANTIATE_TEST_SUITE_P(ExecutionTransfer, GivenBack,
                         ::testing::Values(BackToFour{"resumes", true, 0},
                                           BackToFour{"does_not", false, 1},
                                           BackToFour{"lost_contact", std::nullopt, 1}),
                         [](const auto& one) { return one.param.name; });

TEST(ExecutionTransfer, AGiveBackThatExpiredUnansweredMayStillHaveBeenMade) {
  GroundControl ground = control(4);
  ground.handle(plan_of_three(3), at(5));
  ground.handle(command(ChangeDegree{4, false, true}), at(6));
  ground.handle(Tick{}, at(100));

  ground.handle(HandOverReceived{"marvin", {4, {}, {}}, at(7)}, at(101));

  EXPECT_THAT(ground.board(at(101)).uavs[0].held, IsEmpty());
}

// ---- both sides, with executives of their own and a vehicle between them ----

TEST(ExecutionTransfer, FromThreeToOneAndBackInMidMission) {
  HandoverRig rig(Random(1), 3);
  rig.plan({{1, {}, 10}, {2, {1}, 10}, {3, {2}, 10}});
  rig.change_degree(15, 1);
  rig.change_degree(25, 3);

  rig.play(200);

  EXPECT_THAT(rig.faults(), IsEmpty());
  EXPECT_EQ(rig.degree_on_board(), 3);
}

// A random plan, some of it asked for late, and up to six changes of degree.
std::vector<std::string> faults_of_random_play(std::uint64_t seed) {
  Random random(seed);
  HandoverRig rig(Random(seed + 1), random.chance(0.5) ? 3 : 1);
  std::vector<testing::RigTask> tasks;
  for (std::uint64_t task = 1; task <= 2 + random.below(8); ++task) {
    testing::RigTask one{task, {}, random.chance(0.2) && task > 1 ? 0 : random.uniform(0.5, 12)};
    for (std::uint64_t other = 1; other < task; ++other) {
      if (random.chance(0.3) && tasks[other - 1].seconds > 0) one.after.push_back(other);
    }
    if (one.seconds == 0) one.until = 1;
    one.asked_at = random.chance(0.7) ? 0 : random.uniform(0, 40);
    if (task > 1) one.asked_at = std::max(one.asked_at, tasks.back().asked_at);
    tasks.push_back(one);
  }
  rig.plan(tasks);
  double when = 0;
  for (std::uint64_t i = 0; i < 1 + random.below(6); ++i) {
    when += random.chance(0.3) ? random.uniform(0, 1) : random.uniform(0, 15);
    rig.change_degree(when, 1 + static_cast<int>(random.below(3)));
  }
  rig.play(400);
  return rig.faults();
}

// At random instants, with random latencies, whatever overtakes what: each task is begun once by
// the vehicle, after those it waits for, and comes to its end.
TEST(ExecutionTransfer, NoTaskIsDoneTwiceAndNoneIsLost) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    for (const std::string& fault : faults_of_random_play(seed)) RC_FAIL(fault);
  }));
}

HandOverReceived any_hand_over(Random& random, double now) {
  HandOverReceived out{"marvin", {static_cast<int>(1 + random.below(4)), {}, {}}, at(now)};
  for (std::uint64_t task = 1; task < 8; ++task) {
    if (random.chance(0.5)) continue;
    const auto state = static_cast<TaskState>(random.below(4));
    const std::uint64_t other = 1 + random.below(9);
    const auto wanted = static_cast<TaskState>(random.below(6));
    HeldTask one = held(task, state, random.chance(0.5), {in_state(other, wanted)});
    if (random.chance(0.5)) one.task.exit = {in_state(1 + random.below(9), wanted)};
    out.hand_over.tasks.push_back(one);
  }
  return out;
}

GroundControl::Input any_input(Random& random, double now) {
  const std::uint64_t task = 1 + random.below(8);
  const auto state = static_cast<TaskState>(random.below(6));
  switch (random.below(9)) {
    case 0:
      return any_hand_over(random, now);
    case 1:
      return command(ChangeDegree{static_cast<int>(random.below(6)), false, random.chance(0.5)});
    case 2:
      return RequestReplyReceived{CommandNumber(random.below(30)), random.chance(0.7), ""};
    case 3:
      return PlanBoardReceived{"marvin",
                               static_cast<Degree>(1 + random.below(4)),
                               true,
                               {},
                               at(now - random.uniform(0, 2))};
    case 4:
      return PeerReachable{"marvin", true, random.chance(0.3)};
    case 5:
      return OperatorActs{"it"};
    case 6:
      return command(random.chance(0.5) ? start_of(task) : abort_of(task));
    case 7:
      return status(task, state);
    default:
      return TaskEventReceived{"marvin", id(task), "goto", state, ""};
  }
}

// Whatever is handed over and asked for, each command ends once and nothing is left to wait for.
TEST(ExecutionTransfer, AnySequenceOfInputsIsSurvived) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    Script script = script_of(ResumePlan{"marvin", {id(3)}});
    script.steps[0].once = false;
    GroundControl ground = control(4, script);
    std::map<CommandNumber, int> ends;
    const auto give = [&](const GroundControl::Input& input, double now) {
      for (const auto& change : only<CommandChanged>(ground.handle(input, at(now)))) {
        ends[change.command] += is_settled(change.state) ? 1 : 0;
      }
      RC_ASSERT(ground.next_wakeup().value_or(MissionTime::max()) > at(now));
    };

    double now = 0;
    for (int i = 0; i < 80; ++i) {
      now += random.uniform(0, 3);
      give(any_input(random, now), now);
    }
    for (int i = 0; i < 1000 && ground.next_wakeup(); ++i) {
      now = std::max(now, ground.next_wakeup()->to_seconds());
      give(Tick{}, now);
    }

    RC_ASSERT(!ground.next_wakeup().has_value());
    for (const auto& [number, count] : ends) RC_ASSERT(count == 1);
  }));
}

}  // namespace
}  // namespace skein::ground_station
