// SPDX-License-Identifier: Apache-2.0
#include "skein/ddn/ddn_node.hpp"

#include "testing/bench.hpp"

namespace skein::ddn {
namespace {

using executive::InsertionMode;
using testing::a_task;
using testing::Bench;
using testing::command;
using testing::dispatch;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::rendezvous;
using testing::start;
using testing::status;
using testing::sync;
using testing::telemetry;
using wire::TaskState;
using Words = std::vector<std::string>;

constexpr std::uint64_t kOwn = functional::kFirstOwnId.value();

// ---- at every degree ----

class AtDegree : public ::testing::TestWithParam<int> {
 protected:
  Bench bench{Bench::at_degree(GetParam())};
};
INSTANTIATE_TEST_SUITE_P(DdnNode, AtDegree, ::testing::Values(1, 2, 3));

TEST_P(AtDegree, TellsTheGroundItsDegreeAndAnEmptyPlanWhenItStarts) {
  EXPECT_THAT(bench.give(node::Started{1, true}),
              ElementsAre("ground: degree " + std::to_string(GetParam())));

  ASSERT_EQ(bench.boards().size(), 1U);
  EXPECT_EQ(bench.boards()[0].degree, GetParam());
  EXPECT_THAT(bench.boards()[0].tasks, IsEmpty());
  EXPECT_EQ(bench.records("degree").size(), 1U);
}

TEST_P(AtDegree, PassesTelemetryAndPerceptionsOnToTheGround) {
  EXPECT_THAT(bench.from_sim(telemetry(false)), ElementsAre("ground: telemetry"));
  EXPECT_THAT(bench.from_sim(wire::PerceptionReport{}), ElementsAre("ground: perception"));
}

// An alarm rests on it: it must not be lost. Of a device that goes on finding things not all are.
TEST_P(AtDegree, WhatALookFoundIsAnEventForTheGroundAsLongAsThatIsNews) {
  wire::PerceptionReport found;
  found.device = "ir";
  found.detections.push_back({"fire", {1, 2, 3}, 5, 0.5F});
  for (int i = 0; i < 20; ++i)
    EXPECT_THAT(bench.from_sim(found), ElementsAre("ground: sighting")) << i;
  EXPECT_THAT(bench.from_sim(found), ElementsAre("ground: perception"));
  found.device = "visible";
  EXPECT_THAT(bench.from_sim(found), ElementsAre("ground: sighting"));
}

TEST_P(AtDegree, SendsAPlanBoardOnlyWhenItChanged) {
  bench.give(node::Started{1, true});

  bench.from_sim(telemetry(false));
  EXPECT_THAT(bench.boards(), IsEmpty());
  bench.from_sim(telemetry(true));
  ASSERT_EQ(bench.boards().size(), 1U);
  EXPECT_TRUE(bench.boards()[0].airborne);
  bench.from_sim(telemetry(true));
  EXPECT_THAT(bench.boards(), IsEmpty());
}

TEST_P(AtDegree, TakesRequestsFromTheGroundOnly) {
  EXPECT_THAT(bench.from_heliv(start(1, a_task(1, "goto"), InsertionMode::kVut)), IsEmpty());
  EXPECT_THAT(bench.from_heliv(dispatch(1, "goto")), IsEmpty());

  EXPECT_EQ(bench.records("dropped").size(), 1U);
}

TEST_P(AtDegree, TakesStatusesAndTelemetryFromTheSimulatorOnly) {
  EXPECT_THAT(bench.from_heliv(status(1, TaskState::kEnded)), IsEmpty());
  EXPECT_THAT(bench.from_heliv(telemetry(true)), IsEmpty());
  EXPECT_THAT(bench.from_ground(wire::PerceptionReport{}), IsEmpty());
}

TEST_P(AtDegree, LogsWhatItDropsOncePerSenderAndSlot) {
  bench.from_heliv(telemetry(true));
  EXPECT_EQ(bench.records("dropped").size(), 1U);

  bench.from_heliv(telemetry(true));

  EXPECT_THAT(bench.records("dropped"), IsEmpty());
}

TEST_P(AtDegree, IsIndifferentToSlotsThatAreNotForIt) {
  EXPECT_THAT(bench.from_ground(wire::Alarm{}), IsEmpty());
  EXPECT_THAT(bench.from_ground(wire::SeenObject{}), IsEmpty()) << "an object has a name";
  EXPECT_THAT(bench.from_ground(wire::MissionState{}), IsEmpty());
  EXPECT_THAT(bench.give(node::JobDone{}), IsEmpty());
  EXPECT_THAT(bench.give(node::Undelivered{}), IsEmpty());
}

TEST_P(AtDegree, NotesAWordToAPartnerThatDidNotArrive) {
  node::Undelivered lost;
  lost.to = node::NodeNumber(1);
  lost.slot = wire::Slot::kNegotiationMessage;
  bench.give(lost);
  EXPECT_THAT(bench.records("notice"), IsEmpty()) << "negotiations say it again";
  lost.slot = wire::Slot::kSyncMessage;
  bench.give(lost);

  ASSERT_EQ(bench.records("notice").size(), 1U);
  EXPECT_EQ(bench.records("notice")[0].text("text"),
            "a synchronisation message to ground was not delivered in its lifetime");
}

TEST_P(AtDegree, GivesTheSameAnswerToACommandSeenAgainAndDoesNothingElse) {
  const wire::TaskRequest request = start(7, a_task(1, "goto"));
  const std::vector<std::string> first = bench.from_ground(request);
  const auto& answer = first.at(0);

  EXPECT_THAT(bench.from_ground(request), ElementsAre(answer));
}

// A ground station that was restarted numbers its commands from 1 again.
TEST_P(AtDegree, TakesTheSameNumberOfALaterGroundStationForAnotherCommand) {
  bench.from_ground(start(7, a_task(1, "goto")));
  wire::TaskRequest later = command(7, executive::Suppress{executive::TaskId(99)});
  later.header.incarnation = 2;

  const auto words = bench.from_ground(later);

  ASSERT_EQ(words.size(), 1U);
  EXPECT_NE(words[0], "ground: reply 7 accepted");
  EXPECT_EQ(bench.sent<wire::RequestReply>()->kind, wire::RequestKind::kSuppress);
}

TEST_P(AtDegree, RefusesIdsThatAreItsOwn) {
  EXPECT_THAT(bench.from_ground(start(1, a_task(kOwn, "goto")))[0],
              ::testing::StartsWith("ground: reply 1 refused"));
  EXPECT_THAT(bench.from_ground(dispatch(kOwn, "goto")),
              ElementsAre("ground: status 1000000000 aborted"));
}

// ---- degree 1: a transparent connecting point ----

TEST(DdnNodeAtDegree1, PassesElementaryRequestsOnUnchanged) {
  Bench bench(Bench::at_degree(1));
  wire::FunctionalRequest request = dispatch(4, "goto");
  request.parameters = {{"waypoints", "", {1, 2, 3}}};

  EXPECT_THAT(bench.from_ground(request), ElementsAre("sim: dispatch 4 goto"));

  EXPECT_EQ(bench.sent<wire::FunctionalRequest>()->parameters, request.parameters);
}

TEST(DdnNodeAtDegree1, PassesInterruptionsAndStatusesOn) {
  Bench bench(Bench::at_degree(1));
  wire::FunctionalRequest interrupt = dispatch(4, "");
  interrupt.kind = wire::FunctionalRequestKind::kInterrupt;

  EXPECT_THAT(bench.from_sim(status(4, TaskState::kRunning)),
              ElementsAre("ground: status 4 running"));
  EXPECT_THAT(bench.from_ground(interrupt), ElementsAre("sim: interrupt 4"));
  EXPECT_THAT(bench.from_sim(status(4, TaskState::kAborted, "told to")),
              ElementsAre("ground: status 4 aborted"));
  EXPECT_EQ(bench.sent<wire::FunctionalStatus>()->reason, "told to");
}

TEST(DdnNodeAtDegree1, HoldsNoPlan) {
  Bench bench(Bench::at_degree(1));
  bench.give(node::Started{1, true});

  bench.from_ground(dispatch(4, "goto"));

  EXPECT_THAT(bench.boards(), IsEmpty());
  EXPECT_THAT(bench.records("task"), IsEmpty());
}

TEST(DdnNodeAtDegree1, RefusesPlans) {
  Bench bench(Bench::at_degree(1));

  EXPECT_THAT(bench.from_ground(start(3, a_task(8, "goto"))),
              ElementsAre("ground: reply 3 refused: at degree 1 the ground station runs the plan"));

  EXPECT_EQ(bench.sent<wire::RequestReply>()->id, 8U);
}

TEST(DdnNodeAtDegree1, PassesSynchronisationMessagesOfOthersOnToTheGround) {
  Bench bench(Bench::at_degree(1));

  EXPECT_THAT(bench.from_heliv(sync(551, "heliv", "marvin")),
              ElementsAre("ground: sync 551 heliv>marvin"));
  EXPECT_THAT(bench.records("sync"), IsEmpty());
}

// ---- degrees 2 and 3: the MLE on board ----

class WithAnExecutive : public AtDegree {};
INSTANTIATE_TEST_SUITE_P(DdnNode, WithAnExecutive, ::testing::Values(2, 3));

TEST_P(WithAnExecutive, RunsATaskFromTheRequestToItsEnd) {
  executive::Task task = a_task(2, "goto");
  task.parameters.add({"waypoints", "", {1, 2, 3}});

  EXPECT_THAT(bench.from_ground(start(1, task)),
              ElementsAre("ground: reply 1 accepted", "ground: 2 scheduled", "ground: 2 started",
                          "sim: dispatch 2 goto"));
  EXPECT_EQ(bench.sent<wire::FunctionalRequest>()->parameters[0].numbers,
            (std::vector<double>{1, 2, 3}));
  EXPECT_THAT(bench.from_sim(status(2, TaskState::kRunning)), ElementsAre("ground: 2 running"));
  EXPECT_THAT(bench.from_sim(status(2, TaskState::kEnded)), ElementsAre("ground: 2 ended"));
}

TEST_P(WithAnExecutive, LogsEachRequestAndEachStateOnce) {
  bench.from_ground(start(1, a_task(2, "goto"), InsertionMode::kVut));

  ASSERT_EQ(bench.records("request").size(), 1U);
  EXPECT_EQ(bench.records("request")[0].text("request"), "START");
  EXPECT_EQ(bench.records("request")[0].text("mode"), "VUT");
  EXPECT_TRUE(bench.records("request")[0].truth("accepted"));
  ASSERT_EQ(bench.records("task").size(), 2U);
  EXPECT_EQ(bench.records("task")[0].text("state"), "scheduled");
  EXPECT_EQ(bench.records("task")[1].text("state"), "started");
}

TEST_P(WithAnExecutive, ShowsThePlanOnItsBoardAfterEachChange) {
  bench.from_ground(start(1, a_task(2, "goto")));
  ASSERT_EQ(bench.boards().size(), 1U);
  ASSERT_EQ(bench.boards()[0].tasks.size(), 1U);
  EXPECT_EQ(bench.boards()[0].tasks[0].state, TaskState::kStarted);

  bench.from_sim(status(2, TaskState::kAborted, "engine"));

  ASSERT_EQ(bench.boards().size(), 1U);
  EXPECT_EQ(bench.boards()[0].tasks[0].state, TaskState::kAborted);
  EXPECT_EQ(bench.boards()[0].tasks[0].reason, "engine");
}

TEST_P(WithAnExecutive, KeepsDependenciesWithoutAskingTheGround) {
  executive::Task land = a_task(3, "land");
  land.preconditions = {{testing::in_state(2, executive::TaskState::kEnded)}};
  bench.from_ground(start(1, a_task(2, "goto")));
  bench.from_ground(start(2, land));

  EXPECT_THAT(bench.from_sim(status(2, TaskState::kEnded)),
              ElementsAre("ground: 2 ended", "ground: 3 started", "sim: dispatch 3 land"));
}

TEST_P(WithAnExecutive, InterruptsWhatTheGroundAborts) {
  bench.from_ground(start(1, a_task(2, "goto")));

  EXPECT_THAT(bench.from_ground(command(2, executive::Abort{executive::TaskId(2)})),
              ElementsAre("ground: reply 2 accepted", "ground: 2 aborting", "sim: interrupt 2"));
}

TEST_P(WithAnExecutive, AnswersARefusedRequestWithTheReason) {
  EXPECT_THAT(bench.from_ground(command(5, executive::Abort{executive::TaskId(44)}))[0],
              ::testing::StartsWith("ground: reply 5 refused: "));

  ASSERT_EQ(bench.records("request").size(), 1U);
  EXPECT_FALSE(bench.records("request")[0].truth("accepted"));
  EXPECT_FALSE(bench.records("request")[0].text("why").empty());
}

TEST_P(WithAnExecutive, ExecutesACommandOnce) {
  const wire::TaskRequest request = start(1, a_task(2, "goto"));
  bench.from_ground(request);

  EXPECT_THAT(bench.from_ground(request), ElementsAre("ground: reply 1 accepted"));
  EXPECT_THAT(bench.records("request"), IsEmpty());
  EXPECT_THAT(bench.boards(), IsEmpty());
}

TEST_P(WithAnExecutive, RefusesElementaryRequests) {
  EXPECT_THAT(bench.from_ground(dispatch(9, "goto")), ElementsAre("ground: status 9 aborted"));

  EXPECT_EQ(bench.sent<wire::FunctionalStatus>()->reason,
            "elementary requests are taken at degree 1 only");
}

TEST_P(WithAnExecutive, RefusesJointTasksForWantOfADeliberativeLayer) {
  EXPECT_THAT(bench.from_ground(start(1, a_task(2, "joint:lift"))),
              ElementsAre("ground: reply 1 accepted", "ground: 2 scheduled", "ground: 2 started",
                          "ground: 2 aborted"));

  EXPECT_EQ(bench.records("task").back().text("reason"), "joint tasks need a deliberative layer");
}

TEST_P(WithAnExecutive, AbortsATaskThatTheFunctionalLayerNeverAnswers) {
  bench.from_ground(start(1, a_task(2, "goto")));

  EXPECT_THAT(bench.wake_at(119), IsEmpty());
  EXPECT_EQ(bench.node().next_wakeup(), testing::at(120));
  const auto words = bench.wake_at(120);

  EXPECT_THAT(words, ::testing::Contains("ground: 2 aborted"));
}

TEST_P(WithAnExecutive, ACommandOfAnUnknownUavToSynchroniseWithIsLoggedAndHarmless) {
  executive::Task task = rendezvous(2, 551);
  task.synchronisation->receivers = {"nobody"};

  bench.from_ground(start(1, task));

  ASSERT_EQ(bench.records("notice").size(), 1U);
  EXPECT_EQ(bench.records("notice")[0].text("text"), "no UAV 'nobody' to synchronise with");
}

// What flies is known by telemetry, not only by the tasks that take off and land.
TEST(DdnNode, LearnsFromTelemetryThatItFlies) {
  DdnConfig config = Bench::at_degree(3);
  config.background_type = "wait";
  Bench bench(config);

  const auto words = bench.from_sim(telemetry(true));

  EXPECT_THAT(words, ::testing::Contains(::testing::MatchesRegex("sim: dispatch 9[0-9]* wait")));
}

// ---- synchronisation ----

TEST(DdnNode, SendsSynchronisationMessagesThroughTheGroundAtDegree2) {
  Bench bench(Bench::at_degree(2));

  EXPECT_THAT(bench.from_ground(start(1, rendezvous(2, 551))),
              ::testing::Contains("ground: sync 551 marvin>heliv"));
  EXPECT_EQ(bench.records("sync").size(), 1U);
}

TEST(DdnNode, SendsSynchronisationMessagesStraightToTheOtherAtDegree3) {
  Bench bench(Bench::at_degree(3));

  const auto words = bench.from_ground(start(1, rendezvous(2, 551)));

  EXPECT_THAT(words, ::testing::Contains("heliv: sync 551 marvin>heliv"));
  EXPECT_THAT(words, ::testing::Not(::testing::Contains("ground: sync 551 marvin>heliv")));
}

struct PartnerCase {
  std::string who;
  int degree;
  std::string way;
};
class DegreeOfThePartner : public ::testing::TestWithParam<PartnerCase> {};

TEST_P(DegreeOfThePartner, CountsForTheWayOfASynchronisationMessageTo) {
  Bench bench(Bench::at_degree(3));
  wire::AutonomyDegree said;
  said.uav = "heliv";
  said.degree = static_cast<std::uint8_t>(GetParam().degree);
  bench.from_heliv(said);

  EXPECT_THAT(bench.from_ground(start(1, rendezvous(2, 551))),
              ::testing::Contains(GetParam().way + ": sync 551 marvin>heliv"));
}

INSTANTIATE_TEST_SUITE_P(DdnNode, DegreeOfThePartner,
                         ::testing::Values(PartnerCase{"the_ground_runs_its_plan", 1, "ground"},
                                           PartnerCase{"the_ground_relays_for_it", 2, "ground"},
                                           PartnerCase{"both_from_3_on", 3, "heliv"},
                                           PartnerCase{"it_deliberates", 4, "heliv"},
                                           PartnerCase{"a_degree_that_is_none_says_nothing", 9,
                                                       "heliv"},
                                           PartnerCase{"nor_does_none", 0, "heliv"}),
                         [](const auto& one) { return one.param.who; });

TEST(DdnNode, BelievesNobodyWhoSaysTheDegreeOfAnother) {
  Bench bench(Bench::at_degree(3));
  wire::AutonomyDegree said;
  said.uav = "karma";
  said.degree = 2;

  bench.from_heliv(said);

  EXPECT_EQ(bench.records("dropped").size(), 1U);
}

TEST_P(WithAnExecutive, EndsARendezvousWithTheMessageOfTheOther) {
  bench.from_ground(start(1, rendezvous(2, 551)));

  EXPECT_THAT(bench.from_heliv(sync(551, "heliv", "marvin")), ElementsAre("ground: 2 ended"));

  ASSERT_EQ(bench.records("sync").size(), 1U);
  EXPECT_EQ(bench.records("sync")[0].text("direction"), "received");
}

TEST_P(WithAnExecutive, TakesARelayedMessageOfTheOtherFromTheGround) {
  bench.from_ground(start(1, rendezvous(2, 551)));

  EXPECT_THAT(bench.from_ground(sync(551, "heliv", "marvin")), ElementsAre("ground: 2 ended"));
}

TEST(DdnNode, SendsItsMessageAgainToWhoComesBackInReach) {
  Bench bench(Bench::at_degree(3));
  bench.from_ground(start(1, rendezvous(2, 551)));
  bench.hear(bench.heliv(), false);

  EXPECT_THAT(bench.hear(bench.heliv(), true), ElementsAre("heliv: sync 551 marvin>heliv"));
}

TEST(DdnNode, SendsNothingAgainWhenSomebodyElseComesBack) {
  Bench bench(Bench::at_degree(3));
  bench.from_ground(start(1, rendezvous(2, 551)));

  EXPECT_THAT(bench.hear_ground(true), IsEmpty());
}

}  // namespace
}  // namespace skein::ddn
