// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/monitoring.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "skein/foundation/random.hpp"
#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using executive::TaskState;
using testing::a_task;
using testing::abort_of;
using testing::at;
using ::testing::ElementsAre;
using testing::first;
using ::testing::HasSubstr;
using testing::id;
using ::testing::IsEmpty;
using testing::only;
using ::testing::SizeIs;
using testing::start_of;
using Effects = std::vector<Monitoring::Effect>;

Monitoring two_uavs() { return Monitoring({{"marvin", 3}, {"heliv", 2}}); }

IssueCommand a_command(Request request, double expires = 100) {
  return {"marvin", std::move(request), at(expires)};
}

TaskEventReceived event(std::uint64_t task, TaskState state, const std::string& uav = "marvin") {
  return {uav, id(task), "goto", state, ""};
}

std::vector<CommandState> states(const Effects& effects) {
  std::vector<CommandState> out;
  for (const CommandChanged& change : only<CommandChanged>(effects)) out.push_back(change.state);
  return out;
}

std::vector<TaskState> told(const Effects& effects) {
  std::vector<TaskState> out;
  for (const TaskChanged& change : only<TaskChanged>(effects)) out.push_back(change.state);
  return out;
}

TaskState state_of(const Monitoring& mcs, std::uint64_t task) {
  const std::optional<TaskOnBoard> found = mcs.find_task("marvin", id(task));
  EXPECT_TRUE(found);
  return found ? found->state : TaskState::kScheduled;
}

// ---- commands ----

TEST(Monitoring, ACommandIsNumberedIssuedAndSent) {
  Monitoring mcs = two_uavs();

  const Effects effects = mcs.handle(a_command(start_of(3)), at(1));

  const auto change = first<CommandChanged>(effects);
  EXPECT_EQ(change.command, CommandNumber(1));
  EXPECT_EQ(change.what, "START 3 goto");
  EXPECT_EQ(change.state, CommandState::kIssued);
  const auto sent = first<SendRequest>(effects);
  EXPECT_EQ(sent.command, CommandNumber(1));
  EXPECT_EQ(sent.uav, "marvin");
  EXPECT_EQ(sent.expires, at(100));
  EXPECT_EQ(mcs.board(at(1)).uavs[0].commands_pending, 1U);
}

TEST(Monitoring, EveryRequestHasItsWords) {
  Monitoring mcs = two_uavs();
  world::Volume tower;
  tower.name = "tower";
  const std::vector<std::pair<Request, std::string>> table = {
      {start_of(1, "takeoff"), "START 1 takeoff"},
      {abort_of(2), "ABORT 2"},
      {executive::ProcessMessage{"go"}, "PROCESS-MSG go"},
      {executive::UpdateConditions{id(4), {}, {}}, "UPDATE-COND 4"},
      {executive::Suppress{id(5)}, "SUPPRESS 5"},
      {mission::UnitMission{mission::MissionId(2), {{}, {}, {}}, {}, false, false, ""},
       "MISSION 2 (3 tasks)"},
      {mission::CancelGoals{{mission::GoalId(701), mission::GoalId(702)}, {}, true},
       "CANCEL 701 702"},
      {mission::CancelGoals{{}, mission::MissionId(2), true}, "CANCEL mission 2"},
      {mission::CancelGoals{}, "CANCEL all"},
      {mission::ChangeWorld{tower, false}, "CLOSE tower"},
      {mission::ChangeWorld{tower, true}, "OPEN tower"},
      {mission::ChangeDegree{1, false, true}, "DEGREE 1"},
  };

  for (const auto& [request, words] : table) {
    EXPECT_EQ(first<CommandChanged>(mcs.handle(a_command(request), at(1))).what, words);
  }
}

TEST(Monitoring, TheAnswerClosesACommand) {
  Monitoring mcs = two_uavs();
  mcs.handle(a_command(start_of(3)), at(1));
  mcs.handle(a_command(start_of(4)), at(1));

  const Effects yes = mcs.handle(RequestReplyReceived{CommandNumber(1), true, ""}, at(2));
  const Effects no = mcs.handle(RequestReplyReceived{CommandNumber(2), false, "known id"}, at(2));

  EXPECT_THAT(states(yes), ElementsAre(CommandState::kDelivered, CommandState::kAcknowledged));
  EXPECT_THAT(states(no), ElementsAre(CommandState::kDelivered, CommandState::kRefused));
  EXPECT_EQ(only<CommandChanged>(no).back().why, "known id");
  EXPECT_EQ(mcs.board(at(2)).uavs[0].commands_pending, 0U);
  EXPECT_EQ(mcs.next_wakeup(), std::nullopt);
}

TEST(Monitoring, AnAnswerUnderWayAtTheExpiryStillCounts) {
  Monitoring mcs({{"marvin", 3}}, Duration::seconds(5));
  mcs.handle(a_command(start_of(3), 10), at(1));
  mcs.handle(a_command(start_of(4), 10), at(1));

  const Effects in_time = mcs.handle(RequestReplyReceived{CommandNumber(1), true, ""}, at(14));
  EXPECT_EQ(mcs.next_wakeup(), at(15));
  const Effects too_late = mcs.handle(Tick{}, at(15));

  EXPECT_THAT(states(in_time), ElementsAre(CommandState::kDelivered, CommandState::kAcknowledged));
  EXPECT_THAT(states(too_late), ElementsAre(CommandState::kExpired));
}

// Found by an outsider's missions: it said that "command 1 is not pending, yet acknowledged".
TEST(Monitoring, AnAnswerToWhatHasExpiredIsToldOnceWithWhatWasAsked) {
  const auto answered = [](bool accepted) {
    Monitoring mcs = two_uavs();
    mcs.handle(a_command(start_of(3), 10), at(1));
    mcs.handle(Tick{}, at(50));
    const RequestReplyReceived answer{CommandNumber(1), accepted, accepted ? "" : "known id"};
    const Effects effects = mcs.handle(answer, at(51));
    EXPECT_THAT(states(effects), IsEmpty());
    const Effects again = mcs.handle(answer, at(52));
    EXPECT_THAT(only<Anomaly>(again), SizeIs(1));
    EXPECT_THAT(only<Anomaly>(again)[0].why, HasSubstr("is not pending"));
    const auto told = only<Anomaly>(effects);
    return told.size() == 1 ? told[0].why : "";
  };

  EXPECT_EQ(answered(true),
            "command 1 (START 3 goto, for marvin) had expired, and was carried out all the same");
  EXPECT_EQ(answered(false),
            "command 1 (START 3 goto, for marvin) had expired, and was refused later: known id");
}

TEST(Monitoring, OnlySoManyExpiredCommandsAreRemembered) {
  Monitoring mcs = two_uavs();
  for (int i = 0; i < 65; ++i) mcs.handle(a_command(start_of(3), 10), at(1));
  mcs.handle(Tick{}, at(50));

  const auto told = [&](std::uint64_t number) {
    return first<Anomaly>(mcs.handle(RequestReplyReceived{CommandNumber(number), true, ""}, at(51)))
        .why;
  };
  EXPECT_THAT(told(1), HasSubstr("is not pending"));
  EXPECT_THAT(told(2), HasSubstr("all the same"));
}

TEST(Monitoring, ItIsToldOnceThatACommandIsWithTheUavsNodeBeforeThatAnswers) {
  Monitoring mcs = two_uavs();
  mcs.handle(a_command(start_of(3)), at(1));

  const Effects there = mcs.handle(CommandDelivered{CommandNumber(1)}, at(2));
  const Effects again = mcs.handle(CommandDelivered{CommandNumber(1)}, at(3));
  const Effects yes = mcs.handle(RequestReplyReceived{CommandNumber(1), true, ""}, at(4));
  const Effects late = mcs.handle(CommandDelivered{CommandNumber(1)}, at(5));

  EXPECT_THAT(states(there), ElementsAre(CommandState::kDelivered));
  EXPECT_THAT(states(again), IsEmpty());
  EXPECT_THAT(states(yes), ElementsAre(CommandState::kAcknowledged));
  EXPECT_THAT(late, IsEmpty());
  EXPECT_EQ(mcs.board(at(3)).uavs[0].commands_pending, 0U);
}

TEST(Monitoring, WhatIsDeliveredAndNeverAnsweredExpires) {
  Monitoring mcs({{"marvin", 3}}, Duration::seconds(5));
  mcs.handle(a_command(start_of(3), 10), at(1));
  mcs.handle(CommandDelivered{CommandNumber(1)}, at(2));

  const Effects effects = mcs.handle(Tick{}, at(15));

  EXPECT_THAT(states(effects), ElementsAre(CommandState::kExpired));
  EXPECT_EQ(first<CommandChanged>(effects).why, "no answer");
}

TEST(Monitoring, WhatCannotBeDeliveredExpires) {
  Monitoring mcs = two_uavs();
  mcs.handle(a_command(start_of(3)), at(1));

  const Effects effects = mcs.handle(CommandUndelivered{CommandNumber(1)}, at(100));

  EXPECT_THAT(states(effects), ElementsAre(CommandState::kExpired));
  EXPECT_EQ(first<CommandChanged>(effects).why, "not delivered: no contact in its lifetime");
}

TEST(Monitoring, ThatAnAnsweredCommandWasNotAcknowledgedIsNothingNew) {
  Monitoring mcs = two_uavs();
  mcs.handle(a_command(start_of(3)), at(1));
  mcs.handle(RequestReplyReceived{CommandNumber(1), true}, at(2));

  EXPECT_THAT(mcs.handle(CommandUndelivered{CommandNumber(1)}, at(100)), IsEmpty());
}

TEST(Monitoring, ACommandToNobodyIsRefusedAndAnExpiredOneIsNotSent) {
  Monitoring mcs = two_uavs();

  const Effects nobody = mcs.handle(IssueCommand{"karma", start_of(1), at(10)}, at(1));
  const Effects stale = mcs.handle(a_command(start_of(1), 0), at(1));

  EXPECT_THAT(states(nobody), ElementsAre(CommandState::kIssued, CommandState::kRefused));
  EXPECT_THAT(states(stale), ElementsAre(CommandState::kIssued, CommandState::kExpired));
  EXPECT_THAT(only<SendRequest>(nobody), IsEmpty());
  EXPECT_THAT(only<SendRequest>(stale), IsEmpty());
}

TEST(Monitoring, AbortEverythingNamesWhatIsOpenOrUnderWayFromTheHighestId) {
  Monitoring mcs = two_uavs();
  mcs.handle(event(1, TaskState::kEnded), at(1));
  mcs.handle(event(2, TaskState::kRunning), at(1));
  mcs.handle(event(3, TaskState::kScheduled), at(1));
  mcs.handle(event(9, TaskState::kRunning, "heliv"), at(1));
  mcs.handle(event(executive::kFirstBackgroundId.value(), TaskState::kRunning), at(1));
  mcs.handle(a_command(start_of(7)), at(1));

  const Effects effects = mcs.handle(AbortEverything{"marvin", at(50)}, at(2));

  std::vector<std::string> what;
  for (const auto& change : only<CommandChanged>(effects)) what.push_back(change.what);
  EXPECT_THAT(what, ElementsAre("ABORT 7", "ABORT 3", "ABORT 2"));
}

// Whatever happens in whatever order, each command ends exactly once, and by its deadline.
TEST(Monitoring, EveryCommandEndsInExactlyOneState) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    Monitoring mcs = two_uavs();
    std::map<CommandNumber, std::vector<CommandState>> history;
    const auto give = [&](const Monitoring::Input& input, double now) {
      for (const CommandChanged& change : only<CommandChanged>(mcs.handle(input, at(now)))) {
        history[change.command].push_back(change.state);
      }
    };

    double now = 0;
    for (int i = 0; i < 60; ++i) {
      now += random.uniform(0, 4);
      const std::string uav = random.chance(0.5)   ? "marvin"
                              : random.chance(0.8) ? "heliv"
                                                   : "nobody";
      const CommandNumber number(random.below(20));
      const std::uint64_t task = random.below(6);
      switch (random.below(9)) {
        case 8:
          give(CommandDelivered{number}, now);
          break;
        case 0:
        case 1:
          give(IssueCommand{uav, random.chance(0.6) ? start_of(task) : abort_of(task),
                            at(now + random.uniform(-2, 20))},
               now);
          break;
        case 2:
          give(RequestReplyReceived{number, random.chance(0.5), ""}, now);
          break;
        case 3:
          give(CommandUndelivered{number}, now);
          break;
        case 4:
          give(PeerReachable{uav, true, random.chance(0.5)}, now);
          break;
        case 5:
          give(event(task, static_cast<TaskState>(random.below(6)), uav), now);
          break;
        case 6:
          give(AbortEverything{uav, at(now + random.uniform(0, 20))}, now);
          break;
        default:
          give(Tick{}, now);
      }
    }
    while (const auto wakeup = mcs.next_wakeup()) give(Tick{}, wakeup->to_seconds());

    for (const auto& [number, states_of_it] : history) {
      const std::size_t told = states_of_it.size();
      RC_ASSERT(states_of_it.front() == CommandState::kIssued);
      RC_ASSERT(told == 2U || (told == 3U && states_of_it[1] == CommandState::kDelivered));
      RC_ASSERT(is_settled(states_of_it.back()));
      RC_ASSERT(states_of_it.back() != CommandState::kAcknowledged || told == 3U);
    }
    for (const UavOnBoard& uav : mcs.board(at(now)).uavs) RC_ASSERT(uav.commands_pending == 0U);
  }));
}

// ---- tasks ----

TEST(Monitoring, EachStateOfATaskIsToldOnce) {
  Monitoring mcs = two_uavs();

  const Effects once = mcs.handle(event(1, TaskState::kRunning), at(1));
  const Effects twice = mcs.handle(event(1, TaskState::kRunning), at(2));

  EXPECT_THAT(told(once), ElementsAre(TaskState::kRunning));
  EXPECT_THAT(told(twice), IsEmpty());
}

TEST(Monitoring, TheBoardNeverGoesBackButLateStatesAreTold) {
  Monitoring mcs = two_uavs();
  mcs.handle(PlanBoardReceived{"marvin", 3, true, {{id(1), "goto", TaskState::kEnded}}}, at(1));

  const Effects late = mcs.handle(event(1, TaskState::kRunning), at(2));

  EXPECT_THAT(told(late), ElementsAre(TaskState::kRunning));
  EXPECT_EQ(state_of(mcs, 1), TaskState::kEnded);
}

TEST(Monitoring, TerminalStatesStay) {
  Monitoring mcs = two_uavs();
  mcs.handle(event(1, TaskState::kAborted), at(1));

  mcs.handle(event(1, TaskState::kEnded), at(2));

  EXPECT_EQ(state_of(mcs, 1), TaskState::kAborted);
}

TEST(Monitoring, APlanBoardTellsTheDegree) {
  Monitoring mcs = two_uavs();

  const Effects changed = mcs.handle(PlanBoardReceived{"marvin", 2, false, {}}, at(1));
  const Effects same = mcs.handle(PlanBoardReceived{"marvin", 2, false, {}}, at(2));

  EXPECT_EQ(first<DegreeChanged>(changed).degree, 2);
  EXPECT_THAT(only<DegreeChanged>(same), IsEmpty());
  EXPECT_EQ(mcs.degree_of("marvin"), 2);
}

TEST(Monitoring, UnknownUavsAreAnomalies) {
  Monitoring mcs = two_uavs();
  const std::vector<Monitoring::Input> inputs = {
      TelemetryReceived{"karma", {}, at(1)}, event(1, TaskState::kRunning, "karma"),
      PeerReachable{"karma", true, true}, PlanBoardReceived{"karma", 1, true, {}},
      AbortEverything{"karma", at(9)}};

  for (const Monitoring::Input& input : inputs) {
    const Effects effects = mcs.handle(input, at(1));

    ASSERT_THAT(effects, SizeIs(1));
    EXPECT_THAT(first<Anomaly>(effects).why, ::testing::HasSubstr("unknown UAV 'karma'"));
  }
}

TEST(Monitoring, OldTelemetryDoesNotReplaceNewer) {
  Monitoring mcs = two_uavs();
  world::VehicleState high;
  high.position = {0, 0, 50};
  high.airborne = true;

  mcs.handle(TelemetryReceived{"marvin", high, at(10)}, at(10));
  mcs.handle(TelemetryReceived{"marvin", {}, at(9)}, at(11));

  const Board board = mcs.board(at(12));
  EXPECT_EQ(board.at, at(12));
  EXPECT_EQ(board.uavs[0].telemetry_at, at(10));
  EXPECT_EQ(board.uavs[0].telemetry, high);
  EXPECT_TRUE(board.uavs[0].airborne);
  EXPECT_FALSE(board.uavs[1].telemetry.has_value());
}

// ---- restarts ----

TEST(Monitoring, ARestartLosesWhatWasNotTerminal) {
  Monitoring mcs = two_uavs();
  mcs.handle(event(1, TaskState::kEnded), at(1));
  mcs.handle(event(2, TaskState::kRunning), at(1));
  mcs.handle(event(3, TaskState::kScheduled), at(1));

  const Effects effects = mcs.handle(PeerReachable{"marvin", true, true}, at(2));

  EXPECT_THAT(first<UavRestarted>(effects).lost, ElementsAre(id(2), id(3)));
  EXPECT_FALSE(mcs.find_task("marvin", id(1))->lost);
  EXPECT_TRUE(mcs.find_task("marvin", id(2))->lost);
  EXPECT_FALSE(is_open(*mcs.find_task("marvin", id(2))));
}

TEST(Monitoring, ARestartAtDegreeOneLosesNothing) {
  Monitoring mcs({{"marvin", 1}});
  mcs.handle(event(2, TaskState::kRunning), at(1));

  const Effects effects = mcs.handle(PeerReachable{"marvin", true, true}, at(2));

  EXPECT_THAT(effects, IsEmpty()) << "its plan is at the ground";
  EXPECT_FALSE(mcs.find_task("marvin", id(2))->lost);
}

TEST(Monitoring, PendingCommandsAreSentAgainAfterARestartUnlessTheirTaskIsLost) {
  Monitoring mcs = two_uavs();
  mcs.handle(event(2, TaskState::kRunning), at(1));
  mcs.handle(a_command(abort_of(2)), at(1));
  mcs.handle(a_command(start_of(5)), at(1));
  mcs.handle(a_command(abort_of(5)), at(1));
  mcs.handle(IssueCommand{"heliv", start_of(1), at(50)}, at(1));

  const Effects effects = mcs.handle(PeerReachable{"marvin", true, true}, at(2));

  const auto refused = only<CommandChanged>(effects);
  ASSERT_THAT(refused, SizeIs(1));
  EXPECT_EQ(refused[0].command, CommandNumber(1));
  EXPECT_EQ(refused[0].state, CommandState::kRefused);
  const auto again = only<SendRequest>(effects);
  ASSERT_THAT(again, SizeIs(2));
  EXPECT_EQ(again[0].command, CommandNumber(2));
  EXPECT_EQ(again[1].command, CommandNumber(3));
}

TEST(Monitoring, ALostTaskMayBeStartedAnew) {
  Monitoring mcs = two_uavs();
  mcs.handle(event(2, TaskState::kScheduled), at(1));
  mcs.handle(event(2, TaskState::kRunning), at(1));
  mcs.handle(PeerReachable{"marvin", true, true}, at(2));

  EXPECT_THAT(told(mcs.handle(event(2, TaskState::kEnded), at(3))), IsEmpty())
      << "of the former life";
  EXPECT_THAT(told(mcs.handle(event(2, TaskState::kScheduled), at(4))),
              ElementsAre(TaskState::kScheduled));
  EXPECT_THAT(told(mcs.handle(event(2, TaskState::kRunning), at(5))),
              ElementsAre(TaskState::kRunning));
  EXPECT_FALSE(mcs.find_task("marvin", id(2))->lost);
}

TEST(Monitoring, TheBackgroundRoutineIsNumberedAnewAfterARestart) {
  Monitoring mcs = two_uavs();
  const std::uint64_t routine = executive::kFirstBackgroundId.value();
  mcs.handle(event(routine, TaskState::kAborted), at(1));

  mcs.handle(PeerReachable{"marvin", true, true}, at(2));
  mcs.handle(event(routine, TaskState::kScheduled), at(3));

  EXPECT_EQ(state_of(mcs, routine), TaskState::kScheduled);
}

// ---- display ----

TEST(CurrentTask, IsWhatMovesTheVehicleElseWhateverRuns) {
  UavOnBoard uav;
  const auto tell = [&](std::uint64_t task, const char* type, TaskState state) {
    uav.tasks.learn({"marvin", id(task), type, state}, at(1));
  };
  EXPECT_EQ(current_task(uav), nullptr);

  tell(1, "takeshot", TaskState::kRunning);
  EXPECT_EQ(current_task(uav)->id, id(1));

  tell(2, "goto", TaskState::kRunning);
  EXPECT_EQ(current_task(uav)->id, id(2));

  tell(2, "goto", TaskState::kEnded);
  EXPECT_EQ(current_task(uav)->id, id(1));

  uav.tasks.lose();
  EXPECT_EQ(current_task(uav), nullptr);
}

}  // namespace
}  // namespace skein::ground_station
