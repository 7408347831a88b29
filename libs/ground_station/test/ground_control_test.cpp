// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/ground_control.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "skein/foundation/random.hpp"
#include "testing/builders.hpp"
#include "testing/one_ground.hpp"
#include "testing/team.hpp"

namespace skein::ground_station {
namespace {

using executive::InsertionMode;
using executive::TaskState;
using testing::a_step;
using testing::a_task;
using testing::abort_of;
using testing::at;
using testing::command;
using ::testing::Contains;
using testing::control;
using ::testing::ElementsAre;
using testing::first;
using ::testing::HasSubstr;
using testing::id;
using testing::in_state;
using ::testing::IsEmpty;
using testing::only;
using ::testing::SizeIs;
using testing::start_of;
using testing::Team;
using Effects = std::vector<GroundControl::Effect>;

/// Marvin's fire sensor, straight down on a fire at (100, 50).
world::Perception a_fire_seen() {
  world::Perception look;
  look.uav = "marvin";
  look.device = "fire-sensor";
  look.viewpoint = {100, 50, 60};
  look.direction = -world::Vector3::UnitZ();
  look.range = 100;
  look.aperture = 0.8;
  look.detections.push_back({"fire", {100, 50, 0}, 5, 0.9});
  return look;
}

const std::vector<std::string> kNames = {"karma", "heliv", "marvin"};

// ---- one mission, all mixtures of degrees ----

executive::Task rendezvous(std::uint64_t task) {
  executive::Task out = a_task(task, "synchronise");
  out.synchronisation = executive::Synchronisation{551, kNames, kNames, std::nullopt};
  return out;
}

// Take off, go, wait for each other while holding, take shots together, until the operator stops
// it.
SendPlan monitoring_plan(const std::string& uav) {
  executive::Task hold = a_task(4, "wait");
  hold.preconditions = {in_state(2, TaskState::kEnded)};
  hold.exit = {in_state(3, TaskState::kEnded)};
  executive::Task shots = a_task(5, "takeshot");
  shots.preconditions = {in_state(3, TaskState::kEnded)};
  executive::Task meet = rendezvous(3);
  meet.preconditions = {in_state(2, TaskState::kEnded)};
  return {uav,
          {{a_task(1, "takeoff"), InsertionMode::kVut, {}},
           {a_task(2, "goto"), InsertionMode::kDep, {{AtPoints{{{10, 20, 30}}}, "to"}}},
           {meet, InsertionMode::kSeq, {}},
           {hold, InsertionMode::kSeq, {}},
           {shots, InsertionMode::kSeq, {}}}};
}

Trigger everyone(std::uint64_t task, TaskState state) {
  AllOf all;
  for (const std::string& uav : kNames) all.of.push_back({OnTask{uav, id(task), state}});
  return {all};
}

Script monitoring_script() {
  Step go = a_step("go", {AtTime{at(1)}});
  Step watch = a_step("watch", everyone(5, TaskState::kRunning));
  Step stop = a_step("stop", {OnOperator{"end-monitoring"}});
  Step home = a_step("home", everyone(5, TaskState::kAborted));
  const Step end = a_step("end", everyone(6, TaskState::kEnded), {Finish{}});
  go.phase = "Transit";
  watch.phase = "Monitoring";
  home.phase = "Return";
  for (const std::string& uav : kNames) {
    go.actions.emplace_back(monitoring_plan(uav));
    stop.actions.emplace_back(AbortTasks{uav, std::nullopt});
    home.actions.emplace_back(SendPlan{uav, {{a_task(6, "land"), InsertionMode::kSeq, {}}}});
  }
  const OperatorAction ends{
      "end-monitoring", everyone(5, TaskState::kRunning), Duration::seconds(30), {}};
  return {{go, watch, stop, home, end}, {ends}, Duration::seconds(60)};
}

std::vector<Team::Member> members(Degree karma, Degree heliv, Degree marvin) {
  return {{"karma", karma, 3}, {"heliv", heliv, 1.5}, {"marvin", marvin, 1}};
}

const std::vector<std::string> kWholeHistory = {
    "1 scheduled", "1 started", "2 scheduled", "3 scheduled", "4 scheduled", "5 scheduled",
    "1 running",   "1 ended",   "2 started",   "2 running",   "2 ended",     "3 started",
    "3 running",   "4 started", "4 running",   "3 ended",     "4 aborting",  "5 started",
    "4 aborted",   "5 running", "5 aborting",  "5 aborted",   "6 scheduled", "6 started",
    "6 running",   "6 ended"};

// Who comes last finds the others there: its wait is over before it began.
const std::vector<std::string> kHistoryOfTheLast = {
    "1 scheduled", "1 started",   "2 scheduled", "3 scheduled", "4 scheduled", "5 scheduled",
    "1 running",   "1 ended",     "2 started",   "2 running",   "2 ended",     "3 started",
    "3 running",   "3 ended",     "4 aborted",   "5 started",   "5 running",   "5 aborting",
    "5 aborted",   "6 scheduled", "6 started",   "6 running",   "6 ended"};

TEST(GroundControl, OneScriptWorksAtEveryMixtureOfDegrees) {
  for (Degree karma = 1; karma <= 3; ++karma) {
    for (Degree heliv = 1; heliv <= 3; ++heliv) {
      for (Degree marvin = 1; marvin <= 3; ++marvin) {
        SCOPED_TRACE("degrees " + std::to_string(karma) + std::to_string(heliv) +
                     std::to_string(marvin));
        Team team(members(karma, heliv, marvin), monitoring_script(), 0.05);

        ASSERT_TRUE(team.play(600));

        EXPECT_THAT(team.phases(), ElementsAre("Transit", "Monitoring", "Return"));
        EXPECT_THAT(team.anomalies(), IsEmpty());
        for (const std::string& uav : kNames) {
          const auto& expected = uav == "karma" ? kHistoryOfTheLast : kWholeHistory;
          EXPECT_THAT(team.history(uav), ::testing::UnorderedElementsAreArray(expected)) << uav;
        }
        for (const UavOnBoard& uav : team.ground().board(team.now()).uavs) {
          EXPECT_EQ(uav.commands_pending, 0U) << uav.name;
          EXPECT_EQ(uav.tasks.find(id(6))->state, TaskState::kEnded) << uav.name;
        }
      }
    }
  }
}

TEST(GroundControl, NobodyPassesARendezvousBeforeTheLastIsThere) {
  for (const auto& degrees :
       {members(1, 2, 3), members(3, 1, 2), members(2, 3, 1), members(1, 1, 1)}) {
    Team team(degrees, monitoring_script(), 0.05);

    ASSERT_TRUE(team.play(600));

    const double last = team.instant("karma", 3, TaskState::kRunning);
    EXPECT_GT(last, team.instant("marvin", 3, TaskState::kRunning) + 20);
    for (const std::string& uav : kNames) {
      EXPECT_GE(team.instant(uav, 3, TaskState::kEnded), last) << uav;
      EXPECT_LT(team.instant(uav, 3, TaskState::kEnded), last + 1) << uav;
    }
  }
}

TEST(GroundControl, ACutDelaysTheMissionAndLosesNothing) {
  for (const auto& degrees : {members(1, 2, 3), members(2, 2, 2), members(3, 1, 1)}) {
    Team team(degrees, monitoring_script(), 0.05);
    team.cut("heliv", 36, 60);

    EXPECT_TRUE(team.play(600));

    for (const CommandChanged& command : team.commands()) {
      EXPECT_TRUE(!is_settled(command.state) || command.state == CommandState::kAcknowledged);
    }
  }
}

TEST(GroundControl, WhatACutOutlivesExpires) {
  Team team(members(3, 3, 3), monitoring_script(), 0.05);
  team.cut("heliv", 0, 200);

  EXPECT_FALSE(team.play(300));

  std::size_t expired = 0;
  for (const CommandChanged& command : team.commands()) {
    if (command.state == CommandState::kExpired) ++expired;
  }
  EXPECT_EQ(expired, 5U) << "the plan of heliv";
  EXPECT_THAT(team.history("heliv"), IsEmpty());
}

TEST(GroundControl, AScriptCanSendAgainWhatExpired) {
  Script script;
  Step up = a_step("up", {AtTime{at(5)}}, {SendPlan{"heliv", {{a_task(1, "takeoff"), {}, {}}}}});
  Step again = a_step("again", {AnyOf{{{OnExpired{"up"}}, {OnExpired{"again"}}}}}, up.actions);
  again.once = false;
  script.steps = {up, again,
                  a_step("end", {OnTask{"heliv", id(1), TaskState::kEnded}}, {Finish{}})};
  Team team(members(3, 3, 3), script, 0.05);
  team.cut("heliv", 0, 200);

  EXPECT_TRUE(team.play(600));

  std::vector<CommandState> ends;
  for (const CommandChanged& command : team.commands())
    if (is_settled(command.state)) ends.push_back(command.state);
  EXPECT_THAT(ends, ElementsAre(CommandState::kExpired, CommandState::kExpired,
                                CommandState::kExpired, CommandState::kAcknowledged));
}

TEST(GroundControl, AScriptCanSendAgainWhatARestartLost) {
  Script script = monitoring_script();
  Step again = a_step("again", {OnRestart{"marvin"}});
  SendPlan plan = monitoring_plan("marvin");
  plan.tasks.erase(plan.tasks.begin());  // it flies already
  for (PlannedTask& planned : plan.tasks) planned.mode = InsertionMode::kSeq;
  again.actions.emplace_back(plan);
  script.steps.push_back(again);
  Team team(members(1, 2, 3), std::move(script), 0.05);
  team.restart("marvin", 15);

  ASSERT_TRUE(team.play(600));

  EXPECT_THAT(team.history("marvin"), Contains("6 ended"));
  EXPECT_FALSE(team.ground().board(team.now()).uavs[2].tasks.find(id(2))->lost);
}

TEST(GroundControl, TheSameRunTwiceIsTheSame) {
  Team one(members(1, 2, 3), monitoring_script(), 0.05);
  Team two(members(1, 2, 3), monitoring_script(), 0.05);

  one.play(600);
  two.play(600);

  EXPECT_EQ(one.now(), two.now());
  for (const std::string& uav : kNames) EXPECT_EQ(one.history(uav), two.history(uav));
}

// ---- each rule by itself ----

FunctionalStatusReceived status(std::uint64_t task, TaskState state) {
  return {"marvin", {id(task), state, ""}};
}

std::vector<std::string> local_states(const Effects& effects) {
  std::vector<std::string> out;
  for (const LocalTaskEvent& local : only<LocalTaskEvent>(effects)) {
    const executive::TaskEvent& event = local.event;
    out.push_back(skein::to_text(event.id) + " " + std::string(executive::to_text(event.state)));
  }
  return out;
}

TEST(GroundControl, AtDegreeOneTheRequestIsRunHereTaskByTask) {
  GroundControl ground = control({{"marvin", 1, {}}});
  executive::Task task = a_task(1, "goto");
  task.parameters.add({"to", "", {1, 2, 3}});

  const Effects effects =
      ground.handle(command(executive::Start{task, InsertionMode::kSeq}), at(1));

  EXPECT_THAT(only<SendRequest>(effects), IsEmpty());
  EXPECT_TRUE(first<LocalRequestAnswered>(effects).reply.accepted);
  EXPECT_THAT(local_states(effects), ElementsAre("1 scheduled", "1 started"));
  const auto sent = first<SendFunctional>(effects);
  EXPECT_EQ(sent.request.verb, functional::Verb::kDispatch);
  EXPECT_EQ(sent.request.type, "goto");
  EXPECT_EQ(sent.request.parameters, task.parameters);
  const auto changes = only<CommandChanged>(effects);
  ASSERT_THAT(changes, SizeIs(3));
  EXPECT_EQ(changes[1].state, CommandState::kDelivered);
  EXPECT_EQ(changes[2].state, CommandState::kAcknowledged);
}

TEST(GroundControl, AtDegreeOneTheNextTaskFollowsTheStatusOfTheLast) {
  GroundControl ground = control({{"marvin", 1, {}}});
  ground.handle(command(executive::Start{a_task(1), InsertionMode::kDep}), at(1));
  ground.handle(command(executive::Start{a_task(2), InsertionMode::kDep}), at(1));

  const Effects running = ground.handle(status(1, TaskState::kRunning), at(2));
  const Effects ended = ground.handle(status(1, TaskState::kEnded), at(3));

  EXPECT_THAT(local_states(running), ElementsAre("1 running"));
  EXPECT_THAT(local_states(ended), ElementsAre("1 ended", "2 started"));
  EXPECT_EQ(first<SendFunctional>(ended).request.id, id(2));
  EXPECT_EQ(ground.board(at(3)).uavs[0].tasks.find(id(2))->state, TaskState::kStarted);
}

TEST(GroundControl, AtDegreeOneAnAbortInterruptsTheFunctionalLayer) {
  GroundControl ground = control({{"marvin", 1, {}}});
  ground.handle(command(start_of(1)), at(1));

  const Effects effects = ground.handle(command(abort_of(1)), at(2));

  EXPECT_EQ(first<SendFunctional>(effects).request.verb, functional::Verb::kInterrupt);
  EXPECT_EQ(first<SendFunctional>(effects).expires, MissionTime::max()) << "it may run by now";
  EXPECT_EQ(first<SendFunctional>(effects).request.id, id(1));
  EXPECT_EQ(first<SendFunctional>(effects).request.type, "goto");
}

TEST(GroundControl, AtDegreeOneARefusalIsAnsweredAtOnce) {
  GroundControl ground = control({{"marvin", 1, {}}});
  ground.handle(command(start_of(1)), at(1));

  const Effects effects = ground.handle(command(start_of(1)), at(2));

  const auto answer = first<LocalRequestAnswered>(effects);
  EXPECT_FALSE(answer.reply.accepted);
  EXPECT_EQ(only<CommandChanged>(effects).back().state, CommandState::kRefused);
  EXPECT_EQ(only<CommandChanged>(effects).back().why, answer.reply.why);
}

TEST(GroundControl, AtDegreeOneTimeConditionsAndTimeOutsWakeTheGround) {
  executive::Config mle;
  mle.functional_timeout = Duration::seconds(20);
  GroundControl ground = control({{"marvin", 1, mle}});
  const Effects begun = ground.handle(command(start_of(1)), at(1));

  EXPECT_EQ(ground.next_wakeup(), at(21));
  EXPECT_EQ(first<SendFunctional>(begun).expires, at(21)) << "given up, it is not begun later";
  const Effects effects = ground.handle(Tick{}, at(21));

  EXPECT_THAT(local_states(effects), ElementsAre("1 aborted"));
}

TEST(GroundControl, AtDegreeOneAJointTaskIsAborted) {
  GroundControl ground = control({{"marvin", 1, {}}});

  const Effects effects = ground.handle(command(start_of(1, "joint:monitoring")), at(1));

  EXPECT_THAT(local_states(effects), Contains("1 aborted"));
  EXPECT_THAT(only<SendFunctional>(effects), IsEmpty());
}

TEST(GroundControl, AtDegreeOneTheBackgroundRoutineFollowsTheFlight) {
  executive::Config mle;
  mle.background_type = "wait";
  GroundControl ground = control({{"marvin", 1, mle}});
  world::VehicleState flying;
  flying.airborne = true;

  const Effects effects = ground.handle(TelemetryReceived{"marvin", flying, at(1)}, at(1));
  const Effects again = ground.handle(TelemetryReceived{"marvin", flying, at(2)}, at(2));

  EXPECT_EQ(first<SendFunctional>(effects).request.type, "wait");
  EXPECT_THAT(again, IsEmpty());
}

TEST(GroundControl, AtDegreeOneWhatIsUnderWayIsAskedForAgainWhenTheNodeRestarts) {
  GroundControl ground = control({{"marvin", 1, {}}});
  executive::Task meet = a_task(4, "synchronise");
  meet.synchronisation = executive::Synchronisation{1, {"heliv"}, {"marvin"}, std::nullopt};
  ground.handle(command(start_of(1, "goto")), at(1));
  ground.handle(command(start_of(2, "takeshot")), at(1));
  ground.handle(command(start_of(3, "land")), at(1));
  ground.handle(command(executive::Start{meet, InsertionMode::kSeq}), at(1));
  ground.handle(status(2, TaskState::kEnded), at(2));
  ground.handle(command(abort_of(3)), at(3));

  const Effects effects = ground.handle(PeerReachable{"marvin", true, true}, at(4));

  const auto again = only<SendFunctional>(effects);
  ASSERT_THAT(again, SizeIs(2));
  EXPECT_EQ(again[0].request.id, id(1));
  EXPECT_EQ(again[0].request.verb, functional::Verb::kDispatch);
  EXPECT_EQ(again[1].request.id, id(3));
  EXPECT_EQ(again[1].request.verb, functional::Verb::kInterrupt);
  EXPECT_THAT(only<UavRestarted>(effects), IsEmpty());
}

TEST(GroundControl, FromDegreeTwoUpTheRequestGoesToTheUav) {
  for (const Degree degree : {2, 3, 4, 5}) {
    GroundControl ground = control({{"marvin", degree, {}}});

    const Effects effects = ground.handle(command(start_of(1)), at(1));

    EXPECT_THAT(only<SendRequest>(effects), SizeIs(1));
    EXPECT_THAT(only<LocalTaskEvent>(effects), IsEmpty());
  }
}

TEST(GroundControl, AFunctionalStatusWithoutAnMleHereIsAnAnomaly) {
  GroundControl ground = control({{"marvin", 3, {}}});

  const Effects effects = ground.handle(status(1, TaskState::kRunning), at(1));

  EXPECT_THAT(first<Anomaly>(effects).why, HasSubstr("'marvin'"));
}

TEST(GroundControl, AnAlarmSetsTheScriptInMotion) {
  const Action go =
      SendPlan{"heliv", {{a_task(1), InsertionMode::kSeq, {{NearAlarm{0, 50, 40}, "to"}}}}};
  Script script;
  script.steps = {a_step("look", {OnAlarm{AlarmState::kRaised}}, {go})};
  GroundControl ground = control({{"heliv", 3, {}}}, script);
  world::Perception look = a_fire_seen();

  Effects effects;
  for (int i = 1; i < 10 && only<AlarmEvent>(effects).empty(); ++i) {
    look.at = at(2 * i);
    effects = ground.handle(PerceptionReceived{look}, at(2 * i));
  }

  ASSERT_THAT(only<AlarmEvent>(effects), SizeIs(1));
  const auto sent = only<SendRequest>(effects);
  ASSERT_THAT(sent, SizeIs(1));
  const auto& start = std::get<executive::Start>(sent[0].request);
  EXPECT_THAT(start.task.parameters.find("to")->numbers, ElementsAre(150, 50, 40));
  EXPECT_THAT(ground.alarms(), SizeIs(1));
}

TEST(GroundControl, AUavThatRestartedIsToldOfTheAlarmsAgain) {
  GroundControl ground = control({{"heliv", 4, {}}});
  world::Perception look = a_fire_seen();
  for (int i = 1; i < 10; ++i) {
    look.at = at(2 * i);
    ground.handle(PerceptionReceived{look}, at(2 * i));
  }
  ASSERT_THAT(ground.alarms(), SizeIs(1));

  EXPECT_THAT(only<TellAlarm>(ground.handle(PeerReachable{"heliv", true, false}, at(30))),
              IsEmpty());
  const auto told = only<TellAlarm>(ground.handle(PeerReachable{"heliv", true, true}, at(31)));

  ASSERT_THAT(told, SizeIs(1));
  EXPECT_EQ(told[0].uav, "heliv");
  EXPECT_EQ(told[0].alarm.id, AlarmId(1));
}

// One input of a random kind, about a random UAV and task.
GroundControl::Input any_input(Random& random, const std::vector<std::string>& names, double now) {
  const std::string uav = names[random.below(names.size())];
  const std::uint64_t task = 1 + random.below(7);
  const auto state = static_cast<TaskState>(random.below(6));
  switch (random.below(10)) {
    case 0:
      return FunctionalStatusReceived{uav, {id(task), state, ""}};
    case 1:
      return TaskEventReceived{uav, id(task), "goto", state, ""};
    case 2:
      return PeerReachable{uav, random.chance(0.5), random.chance(0.3)};
    case 3:
      return SyncReceived{551, uav, names[random.below(names.size())]};
    case 4:
      return RequestReplyReceived{CommandNumber(random.below(30)), random.chance(0.5), ""};
    case 5:
      if (random.chance(0.5)) return CommandDelivered{CommandNumber(random.below(30))};
      return CommandUndelivered{CommandNumber(random.below(30))};
    case 6: {
      const auto degree = static_cast<Degree>(random.below(7));
      return PlanBoardReceived{uav, degree, random.chance(0.5), {{id(task), "goto", state}}};
    }
    case 7:
      return OperatorCommand{uav, random.chance(0.5) ? start_of(task) : abort_of(task),
                             Duration::seconds(random.uniform(-1, 9))};
    case 8:
      return OperatorActs{"end-monitoring"};
    default:
      break;
  }
  return TelemetryReceived{uav, {}, at(now)};
}

// Whatever comes in, in whatever order, nothing breaks and no command is left over.
TEST(GroundControl, AnySequenceOfInputsIsSurvived) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    GroundControl ground =
        control({{"karma", 1, {}}, {"heliv", 2, {}}, {"marvin", 3, {}}}, monitoring_script());
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
      give(any_input(random, {"karma", "heliv", "marvin", "nobody"}, now), now);
    }
    for (int i = 0; i < 1000; ++i) {
      const auto wakeup = ground.next_wakeup();
      if (!wakeup) break;
      now = std::max(now, wakeup->to_seconds());
      give(Tick{}, now);
    }

    RC_ASSERT(!ground.next_wakeup().has_value());
    for (const auto& [number, count] : ends) RC_ASSERT(count == 1);
  }));
}

}  // namespace
}  // namespace skein::ground_station
