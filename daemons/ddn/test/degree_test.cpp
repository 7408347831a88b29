// SPDX-License-Identifier: Apache-2.0
// Changes of the degree of autonomy among 1, 2 and 3. Source: spec 1.2.
#include <tuple>

#include "testing/bench.hpp"

namespace skein::ddn {
namespace {

using executive::InsertionMode;
using testing::a_task;
using testing::Bench;
using testing::command;
using ::testing::Contains;
using testing::degree;
using testing::dispatch;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::interrupting;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using testing::rendezvous;
using ::testing::SizeIs;
using testing::start;
using testing::status;
using testing::sync;
using testing::telemetry;
using wire::TaskState;

std::string number(int n) { return std::to_string(n); }

// Own tasks are numbered by the millisecond in which they are made.
std::uint64_t own_at(double seconds) {
  return functional::kFirstOwnId.value() + static_cast<std::uint64_t>(seconds * 1000);
}

// 2 runs, 3 waits for it, in the air.
void fly(Bench& bench) {
  bench.from_sim(telemetry(true));
  executive::Task go = a_task(2, "goto");
  go.parameters.add({"waypoints", "", {1, 2, 3}});
  bench.from_ground(start(1, go));
  executive::Task land = a_task(3, "land");
  land.preconditions = {{testing::in_state(2, executive::TaskState::kEnded)}};
  bench.from_ground(start(2, land));
  bench.from_sim(status(2, TaskState::kRunning));
}

// ---- every change ----

class EveryChange : public ::testing::TestWithParam<std::tuple<int, int>> {
 protected:
  int from() const { return std::get<0>(GetParam()); }
  int to() const { return std::get<1>(GetParam()); }
  Bench bench{Bench::at_degree(std::get<0>(GetParam()))};
};
INSTANTIATE_TEST_SUITE_P(DdnNode, EveryChange,
                         ::testing::Combine(::testing::Values(1, 2, 3),
                                            ::testing::Values(1, 2, 3)));

TEST_P(EveryChange, IsAnsweredWithTheDegreeAndThePlanHeld) {
  EXPECT_THAT(bench.from_ground(degree(9, to())),
              ElementsAre("ground: reply 9 accepted", "ground: degree " + number(to()),
                          "ground: hand-over " + number(to()) + ":"));

  EXPECT_EQ(bench.sent<wire::RequestReply>()->kind, wire::RequestKind::kDegree);
  EXPECT_EQ(bench.sent<wire::HandOver>()->uav, "marvin");
}

TEST_P(EveryChange, IsLoggedWithWhoAskedAndHowMuchIsHeld) {
  bench.from_ground(degree(9, to()));

  ASSERT_THAT(bench.records("degree"), SizeIs(1));
  EXPECT_EQ(bench.records("degree")[0].number("degree"), to());
  EXPECT_EQ(bench.records("degree")[0].text("by"), "operator");
  EXPECT_EQ(bench.records("degree")[0].number("held", -1), 0);
}

TEST_P(EveryChange, ShowsOnThePlanBoard) {
  bench.give(node::Started{1, true});

  bench.from_ground(degree(9, to()));

  if (to() == from()) {
    EXPECT_THAT(bench.boards(), IsEmpty());
  } else {
    ASSERT_THAT(bench.boards(), SizeIs(1));
    EXPECT_EQ(bench.boards()[0].degree, to());
  }
}

TEST_P(EveryChange, IsCarriedOutOnce) {
  bench.from_ground(degree(9, to()));
  bench.from_ground(degree(10, from()));

  EXPECT_THAT(bench.from_ground(degree(9, to())), ElementsAre("ground: reply 9 accepted"));
  EXPECT_THAT(bench.records("degree"), IsEmpty());
}

TEST_P(EveryChange, IsTakenFromTheGroundOnly) {
  EXPECT_THAT(bench.from_heliv(degree(9, to())), IsEmpty());

  EXPECT_THAT(bench.records("dropped"), SizeIs(1));
}

TEST_P(EveryChange, OfAnEarlierCommandThatComesAgainIsAnsweredAsBefore) {
  bench.from_ground(degree(9, 77));

  EXPECT_THAT(bench.from_ground(degree(9, to())),
              ElementsAre(HasSubstr("reply 9 refused: degree: 77")));
}

class NoDegree : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(DdnNode, NoDegree, ::testing::Values(0, 6, 9, 255));

TEST_P(NoDegree, IsRefusedWithTheReason) {
  Bench bench(Bench::at_degree(3));

  EXPECT_THAT(bench.from_ground(degree(9, GetParam())),
              ElementsAre("ground: reply 9 refused: degree: " + number(GetParam()) +
                          " is not a degree from 1 to 5"));
  EXPECT_THAT(bench.records("degree"), IsEmpty());
}

TEST(Degree, FourIsRefusedWithoutAPlanningDomain) {
  Bench bench(Bench::at_degree(3));

  EXPECT_THAT(bench.from_ground(degree(9, 4)),
              ElementsAre("ground: reply 9 refused: no planning domain in the scenario: degree 4 "
                          "cannot be had"));
}

// ---- among degrees that execute on board ----

class OnBoard : public ::testing::TestWithParam<std::pair<int, int>> {
 protected:
  Bench bench{Bench::at_degree(GetParam().first)};
  int to() const { return GetParam().second; }
};
INSTANTIATE_TEST_SUITE_P(DdnNode, OnBoard,
                         ::testing::Values(std::pair(3, 2), std::pair(2, 3), std::pair(3, 3)));

TEST_P(OnBoard, WhatRunsGoesOn) {
  fly(bench);

  EXPECT_THAT(bench.from_ground(degree(9, to())),
              ElementsAre("ground: reply 9 accepted", "ground: degree " + number(to()),
                          "ground: hand-over " + number(to()) + ": 2 running, 3 scheduled"));
  EXPECT_THAT(bench.from_sim(status(2, TaskState::kEnded)),
              ElementsAre("ground: 2 ended", "ground: 3 started", "sim: dispatch 3 land"));
}

TEST_P(OnBoard, TheHandOverHasTheTasksWithTheirConditions) {
  fly(bench);
  bench.from_ground(degree(9, to()));

  const wire::HandOver& hand_over = *bench.sent<wire::HandOver>();

  ASSERT_THAT(hand_over.tasks, SizeIs(2));
  EXPECT_EQ(hand_over.tasks[0].task.type, "goto");
  EXPECT_EQ(hand_over.tasks[0].task.parameters[0].numbers, (std::vector<double>{1, 2, 3}));
  EXPECT_TRUE(hand_over.tasks[0].in_executive);
  ASSERT_THAT(hand_over.tasks[1].task.preconditions, SizeIs(1));
  EXPECT_EQ(hand_over.tasks[1].task.preconditions[0].literals[0].task, 2U);
}

TEST_P(OnBoard, AnInterruptionAbortsAllTheHighestIdFirstAndThenWaits) {
  fly(bench);
  bench.set_time(20);

  const auto words = bench.from_ground(interrupting(degree(9, to())));

  EXPECT_THAT(words, ElementsAre("ground: reply 9 accepted", "ground: 3 aborted",
                                 "ground: 2 aborting", "sim: interrupt 2",
                                 "ground: " + number(static_cast<int>(own_at(20))) + " scheduled",
                                 "ground: degree " + number(to()), HasSubstr("2 aborting")));
  EXPECT_THAT(bench.from_sim(status(2, TaskState::kAborted)),
              Contains("sim: dispatch " + std::to_string(own_at(20)) + " wait"));
}

TEST_P(OnBoard, AnInterruptionOnTheGroundNeedsNoWait) {
  bench.from_ground(start(1, a_task(2, "takeshot")));

  const auto words = bench.from_ground(interrupting(degree(9, to())));

  EXPECT_THAT(words, Contains("sim: interrupt 2"));
  EXPECT_THAT(words, Not(Contains(HasSubstr("scheduled"))));
}

TEST(Degree, OnlyTheWayOfSynchronisationMessagesChangesBetween2And3) {
  Bench bench(Bench::at_degree(3));
  bench.from_ground(degree(9, 2));
  EXPECT_THAT(bench.from_ground(start(1, rendezvous(2, 551))),
              Contains("ground: sync 551 marvin>heliv"));

  bench.from_ground(degree(10, 3));

  EXPECT_THAT(bench.from_ground(start(2, rendezvous(3, 552))),
              Contains("heliv: sync 552 marvin>heliv"));
}

// ---- down to 1 ----

TEST(DownToDegree1, ThePlanGoesToTheGroundAndNothingIsInterrupted) {
  Bench bench(Bench::at_degree(3));
  fly(bench);

  EXPECT_THAT(bench.from_ground(degree(9, 1)),
              ElementsAre("ground: reply 9 accepted", "ground: degree 1",
                          "ground: hand-over 1: 2 running, 3 scheduled"));
  ASSERT_THAT(bench.boards(), SizeIs(1));
  EXPECT_THAT(bench.boards()[0].tasks, IsEmpty());
  EXPECT_EQ(bench.records("degree")[0].number("held"), 2);
}

TEST(DownToDegree1, StatusesOfWhatRunsGoToTheGround) {
  Bench bench(Bench::at_degree(3));
  fly(bench);
  bench.from_ground(degree(9, 1));

  EXPECT_THAT(bench.from_ground(dispatch(2, "goto")), ElementsAre("sim: dispatch 2 goto"));
  EXPECT_THAT(bench.from_sim(status(2, TaskState::kRunning)),
              ElementsAre("ground: status 2 running"));
  EXPECT_THAT(bench.from_sim(status(2, TaskState::kEnded)), ElementsAre("ground: status 2 ended"));
  EXPECT_THAT(bench.from_ground(dispatch(3, "land")), ElementsAre("sim: dispatch 3 land"));
}

TEST(DownToDegree1, PlansAreTheGroundsFromNowOn) {
  Bench bench(Bench::at_degree(3));
  fly(bench);
  bench.from_ground(degree(9, 1));

  EXPECT_THAT(bench.from_ground(command(10, executive::Abort{executive::TaskId(2)})),
              ElementsAre(HasSubstr("refused: at degree 1 the ground station runs the plan")));
}

TEST(DownToDegree1, SynchronisationMessagesThatWereHeardGoToTheGroundFirst) {
  Bench bench(Bench::at_degree(3));
  bench.from_heliv(sync(551, "heliv", "marvin"));

  EXPECT_THAT(bench.from_ground(degree(9, 1)),
              ElementsAre("ground: reply 9 accepted", "ground: sync 551 heliv>marvin",
                          "ground: degree 1", "ground: hand-over 1:"));
}

TEST(DownToDegree1, ASynchronisationTheGroundHasTakenOverIsNotCarriedOutHere) {
  Bench bench(Bench::at_degree(3));
  bench.from_ground(start(1, rendezvous(2, 551)));

  EXPECT_THAT(bench.from_ground(degree(9, 1)), Contains("ground: hand-over 1: 2 running"));
  EXPECT_THAT(bench.from_heliv(sync(551, "heliv", "marvin")),
              ElementsAre("ground: sync 551 heliv>marvin"));
}

TEST(DownToDegree1, AnInterruptionIsSeenToItsEndHere) {
  Bench bench(Bench::at_degree(3));
  fly(bench);
  bench.set_time(20);
  const std::string own = std::to_string(own_at(20));

  const auto words = bench.from_ground(interrupting(degree(9, 1)));

  EXPECT_THAT(words, Contains("ground: 2 aborting"));
  EXPECT_THAT(words, Contains("ground: hand-over 1:"));
  EXPECT_THAT(bench.from_sim(status(2, TaskState::kAborted)),
              ElementsAre("ground: 2 aborted", "ground: " + own + " started",
                          "sim: dispatch " + own + " wait"));
}

TEST(DownToDegree1, TheContactPolicyInterruptsWhatWasHandedOver) {
  Bench bench(Bench::with_policy(3, ContactPolicy::kHold));
  bench.hear_ground(true);
  fly(bench);
  bench.from_ground(degree(9, 1));
  bench.set_time(10);
  bench.hear_ground(false);

  EXPECT_THAT(bench.wake_at(40), Contains("sim: interrupt 2"));
}

// ---- up from 1 ----

TEST(UpFromDegree1, WhatTheGroundSendsBackIsTakenAsItRuns) {
  Bench bench(Bench::at_degree(3));
  fly(bench);
  bench.from_ground(degree(9, 1));
  bench.from_ground(degree(10, 2));

  EXPECT_THAT(bench.from_ground(start(11, a_task(2, "goto"))),
              ElementsAre("ground: reply 11 accepted", "ground: 2 scheduled", "ground: 2 started",
                          "sim: dispatch 2 goto"));
  EXPECT_THAT(bench.from_sim(status(2, TaskState::kRunning)), ElementsAre("ground: 2 running"));
  EXPECT_THAT(bench.from_sim(status(2, TaskState::kEnded)), ElementsAre("ground: 2 ended"));
}

// The ground station's executive may have let go of it.
TEST(UpFromDegree1, AStatusThatComesBeforeTheTaskGoesToTheGroundAndIsTold) {
  Bench bench(Bench::at_degree(1));
  bench.from_ground(dispatch(2, "goto"));
  bench.from_ground(degree(10, 3));

  EXPECT_THAT(bench.from_sim(status(2, TaskState::kRunning)),
              ElementsAre("ground: status 2 running"));
  EXPECT_THAT(bench.from_sim(status(2, TaskState::kEnded)),
              ElementsAre("ground: status 2 ended", "ground: 2 ended"));
  EXPECT_THAT(bench.records("notice"), IsEmpty());
}

TEST(UpFromDegree1, ElementaryRequestsAreRefusedFromNowOn) {
  Bench bench(Bench::at_degree(1));
  bench.from_ground(degree(10, 3));

  EXPECT_THAT(bench.from_ground(dispatch(2, "goto")), ElementsAre("ground: status 2 aborted"));
}

TEST(UpFromDegree1, AnInterruptionStopsWhatTheGroundHadRequested) {
  Bench bench(Bench::at_degree(1));
  bench.from_sim(telemetry(true));
  bench.from_ground(dispatch(2, "goto"));

  EXPECT_THAT(bench.from_ground(interrupting(degree(10, 3))), Contains("sim: interrupt 2"));
  EXPECT_THAT(bench.from_sim(status(2, TaskState::kAborted)), Contains(HasSubstr("wait")));
}

// ---- own tasks give way ----

// After an interruption the vehicle waits under id `own`.
std::uint64_t wait_in_the_air(Bench& bench, int at_degree) {
  bench.from_sim(telemetry(true));
  bench.set_time(20);
  bench.from_ground(interrupting(degree(1, at_degree)));
  bench.from_sim(status(own_at(20), TaskState::kRunning));
  return own_at(20);
}

TEST(OwnTasks, GiveWayToATaskThatMovesTheVehicle) {
  Bench bench(Bench::at_degree(3));
  const std::uint64_t own = wait_in_the_air(bench, 3);

  const auto words = bench.from_ground(start(2, a_task(5, "goto")));

  EXPECT_THAT(words, Contains("sim: interrupt " + std::to_string(own)));
  EXPECT_THAT(words, Not(Contains("sim: dispatch 5 goto")));
  EXPECT_THAT(bench.from_sim(status(own, TaskState::kAborted)), Contains("sim: dispatch 5 goto"));
}

TEST(OwnTasks, GiveWayToWhatTheGroundRequestsAtDegree1) {
  Bench bench(Bench::at_degree(1));
  const std::uint64_t own = wait_in_the_air(bench, 1);

  EXPECT_THAT(bench.from_ground(dispatch(5, "goto")),
              Contains("sim: interrupt " + std::to_string(own)));
  EXPECT_THAT(bench.from_sim(status(own, TaskState::kAborted)), Contains("sim: dispatch 5 goto"));
}

TEST(OwnTasks, StayForWhatDoesNotMoveTheVehicle) {
  Bench bench(Bench::at_degree(3));
  wait_in_the_air(bench, 3);

  EXPECT_THAT(bench.from_ground(start(2, a_task(5, "takeshot"))),
              Contains("sim: dispatch 5 takeshot"));
}

class Displacing : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(OwnTasks, Displacing, ::testing::Values(1, 3));

TEST_P(Displacing, ATaskAbortedBeforeItsTurnIsNeverDispatched) {
  Bench bench(Bench::at_degree(GetParam()));
  const std::uint64_t own = wait_in_the_air(bench, GetParam());
  wire::FunctionalRequest interrupt = dispatch(5, "");
  interrupt.kind = wire::FunctionalRequestKind::kInterrupt;

  std::vector<std::string> words;
  if (GetParam() == 1) {
    bench.from_ground(dispatch(5, "goto"));
    words = bench.from_ground(interrupt);
  } else {
    bench.from_ground(start(2, a_task(5, "goto")));
    words = bench.from_ground(command(3, executive::Abort{executive::TaskId(5)}));
  }

  EXPECT_THAT(words, Contains(GetParam() == 1 ? "ground: status 5 aborted" : "ground: 5 aborted"));
  EXPECT_THAT(bench.from_sim(status(own, TaskState::kAborted)),
              Not(Contains("sim: dispatch 5 goto")));
}

}  // namespace
}  // namespace skein::ddn
