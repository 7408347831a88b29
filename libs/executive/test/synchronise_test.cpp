// SPDX-License-Identifier: Apache-2.0
// Synchronisations, carried out inside the executive. Source: spec 2.6.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/mission.hpp"

namespace skein::executive {
namespace {

using testing::cm;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Mission;
using ::testing::SizeIs;
using testing::TaskOf;
using testing::Words;
using enum TaskState;

// The executive under test is that of marvin.
TaskOf meeting(std::uint64_t id, const Words& senders, const Words& receivers) {
  return TaskOf(id, "synchronise").among(senders, receivers);
}
TaskOf rendezvous(std::uint64_t id) {
  return meeting(id, {"marvin", "heliv"}, {"marvin", "heliv"});
}

TEST(Synchronise, RunsAtOnceThenSendsThenWaits) {
  Mission mission;

  EXPECT_THAT(mission.start(rendezvous(1)),
              ElementsAre("1 scheduled", "1 started", "1 running", "sync 551 to heliv"));
  EXPECT_THAT(mission.sync_from("heliv"), ElementsAre("1 ended"));
}

TEST(Synchronise, ARendezvousIsCarriedOutLikewise) {
  Mission mission;

  EXPECT_THAT(
      mission.start(TaskOf(1, "rendezvous").among({"marvin", "heliv"}, {"heliv", "marvin"})),
      ElementsAre("1 scheduled", "1 started", "1 running", "sync 551 to heliv"));
  EXPECT_THAT(mission.sync_from("heliv"), ElementsAre("1 ended"));
}

TEST(Synchronise, AnUrgentMotionInterruptsARendezvousButNotASynchronisationAlongAMotion) {
  Mission mission;
  mission.start(meeting(1, {"heliv"}, {"marvin"}));
  mission.start(TaskOf(2, "rendezvous").among({"heliv"}, {"marvin"}));

  EXPECT_THAT(mission.start(TaskOf(3, "goto"), InsertionMode::kVut),
              ElementsAre("3 scheduled", "2 aborting", "2 aborted", "3 started", "dispatch 3"));
}

TEST(Synchronise, SendsInTheOrderOfTheReceiversOnceToEachAndNotToItself) {
  Mission mission;

  EXPECT_THAT(mission.start(meeting(1, {"marvin", "heliv"},
                                    {"karma", "marvin", "heliv", "karma", "airship"})),
              ElementsAre("1 scheduled", "1 started", "1 running", "sync 551 to karma",
                          "sync 551 to heliv", "sync 551 to airship"));
}

TEST(Synchronise, WaitsForEveryOtherSender) {
  Mission mission;
  mission.start(meeting(1, {"heliv", "karma", "marvin"}, {"marvin"}));

  EXPECT_THAT(mission.sync_from("karma"), IsEmpty());
  EXPECT_THAT(mission.sync_from("heliv"), ElementsAre("1 ended"));
}

TEST(Synchronise, OneThatOnlySendsIsDoneAtOnce) {
  Mission mission;

  EXPECT_THAT(mission.start(meeting(1, {"marvin"}, {"heliv"})),
              ElementsAre("1 scheduled", "1 started", "1 running", "sync 551 to heliv", "1 ended"));
}

TEST(Synchronise, OneThatOnlyReceivesSendsNothing) {
  Mission mission;

  EXPECT_THAT(mission.start(meeting(1, {"heliv"}, {"marvin"})),
              ElementsAre("1 scheduled", "1 started", "1 running"));
  EXPECT_THAT(mission.sync_from("heliv"), ElementsAre("1 ended"));
}

TEST(Synchronise, OneThatDoesNotConcernThisUavIsDoneAtOnce) {
  Mission mission;

  EXPECT_THAT(mission.start(meeting(1, {"heliv"}, {"karma"})),
              ElementsAre("1 scheduled", "1 started", "1 running", "1 ended"));
}

TEST(Synchronise, KeepsAMessageThatArrivesBeforeTheTask) {
  Mission mission;
  mission.sync_from("heliv");

  EXPECT_THAT(mission.start(rendezvous(1)),
              ElementsAre("1 scheduled", "1 started", "1 running", "sync 551 to heliv", "1 ended"));
}

TEST(Synchronise, KeepsAMessageThatArrivesWhileTheTaskIsScheduled) {
  Mission mission;
  mission.start(rendezvous(1).pre({cm("go")}));

  EXPECT_THAT(mission.sync_from("heliv"), IsEmpty());
  EXPECT_THAT(mission.message("go"),
              ElementsAre("1 started", "1 running", "sync 551 to heliv", "1 ended"));
}

TEST(Synchronise, CountsAMessageOnce) {
  Mission mission;
  mission.start(meeting(1, {"heliv", "karma"}, {"marvin"}));
  mission.sync_from("heliv");

  EXPECT_THAT(mission.sync_from("heliv"), IsEmpty());
  EXPECT_EQ(mission.state_of(1), kRunning);
  EXPECT_THAT(mission.sync_from("karma"), ElementsAre("1 ended"));
  EXPECT_THAT(mission.sync_from("karma"), IsEmpty());
}

TEST(Synchronise, IgnoresOtherSynchronisationsAndOtherSenders) {
  Mission mission;
  mission.start(rendezvous(1));

  EXPECT_THAT(mission.sync_from("heliv", 7), IsEmpty());
  EXPECT_THAT(mission.sync_from("karma"), IsEmpty());
  EXPECT_EQ(mission.state_of(1), kRunning);
}

TEST(Synchronise, SendsAgainToWhoComesBackInReach) {
  Mission mission;
  mission.start(rendezvous(1));

  EXPECT_THAT(mission.reachable("heliv"), ElementsAre("sync 551 to heliv"));
  EXPECT_THAT(mission.reachable("karma"), IsEmpty());
}

TEST(Synchronise, SendsAgainEvenOnceItsOwnPartIsOver) {
  Mission mission;
  mission.start(rendezvous(1));
  mission.sync_from("heliv");

  EXPECT_THAT(mission.reachable("heliv"), ElementsAre("sync 551 to heliv"));
}

TEST(Synchronise, SendsNothingAgainBeforeItRunsNorAfterItsInterruption) {
  Mission mission;
  mission.start(rendezvous(1).pre({cm("go")}));

  EXPECT_THAT(mission.reachable("heliv"), IsEmpty());
  mission.message("go");
  mission.abort(1);
  EXPECT_THAT(mission.reachable("heliv"), IsEmpty());
}

TEST(Synchronise, SendsNothingAgainOnceSuppressed) {
  Mission mission;
  mission.start(meeting(1, {"marvin"}, {"heliv"}));
  mission.suppress(1);

  EXPECT_THAT(mission.reachable("heliv"), IsEmpty());
}

TEST(Synchronise, AnAbortGivesAbortingThenAbortedWithoutTheFunctionalLayer) {
  Mission mission;
  mission.start(rendezvous(1));

  EXPECT_THAT(mission.abort(1), ElementsAre("1 aborting", "1 aborted"));
  EXPECT_THAT(mission.sync_from("heliv"), IsEmpty());
}

TEST(Synchronise, AnExitConditionInterruptsItTheSameWay) {
  Mission mission;
  mission.start(rendezvous(1).exit({cm("give up")}));

  EXPECT_THAT(mission.message("give up"), ElementsAre("1 aborting", "1 aborted"));
}

TEST(Synchronise, ItsDeadlineInterruptsItTheSameWay) {
  Mission mission;
  mission.start(rendezvous(1).deadline(30));

  EXPECT_EQ(mission.executive.next_wakeup(), MissionTime::seconds(30));
  EXPECT_THAT(mission.at(30).sync_from("heliv"), ElementsAre("1 aborting", "1 aborted"));
  EXPECT_THAT(mission.reason_of(1), HasSubstr("deadline"));
}

TEST(Synchronise, ItsDeadlineCancelsItWhileItIsScheduled) {
  Mission mission;
  mission.start(rendezvous(1).pre({cm("go")}).deadline(30));

  EXPECT_THAT(mission.at(30).message("go"), ElementsAre("1 aborted"));
}

TEST(Synchronise, ItsDeadlineActsBesideItsExitConditionsAndOutlivesTheirUpdate) {
  Mission mission;
  mission.start(rendezvous(1).exit({cm("a")}).exit({cm("b")}).deadline(30));
  EXPECT_EQ(mission.executive.exit_conditions(TaskId{1}), (Formula{{cm("a")}, {cm("b")}}));

  mission.update(1, {}, Formula{});

  EXPECT_THAT(mission.executive.exit_conditions(TaskId{1}), IsEmpty());
  EXPECT_THAT(mission.at(30).tick(), ElementsAre("1 aborting", "1 aborted"));
}

TEST(Synchronise, ADeadlineThatHasPassedMakesItIncoherent) {
  Mission mission;

  EXPECT_THAT(mission.at(30).start(rendezvous(1).deadline(30)), ElementsAre("1 aborted"));
}

TEST(Synchronise, AStatusFromTheFunctionalLayerDoesNotConcernIt) {
  Mission mission;
  mission.start(rendezvous(1));

  EXPECT_THAT(mission.ends(1), IsEmpty());
  EXPECT_THAT(mission.notices, SizeIs(1));
  EXPECT_EQ(mission.state_of(1), kRunning);
}

TEST(Synchronise, TheFunctionalTimeOutDoesNotConcernIt) {
  Config config = testing::named("marvin");
  config.functional_timeout = Duration::seconds(1);
  Mission mission(config);
  mission.start(rendezvous(1));

  EXPECT_EQ(mission.executive.next_wakeup(), std::nullopt);
  EXPECT_THAT(mission.at(100).tick(), IsEmpty());
}

TEST(Synchronise, TwoTasksOfOneSynchronisationEndByIdWithOneMessage) {
  Mission mission;
  mission.start(meeting(8, {"heliv"}, {"marvin"}));
  mission.start(meeting(2, {"heliv"}, {"marvin"}));

  EXPECT_THAT(mission.sync_from("heliv"), ElementsAre("2 ended", "8 ended"));
}

// Two executives, each fed with what the other sends.
TEST(Synchronise, ARendezvousIsDoneOnBothSides) {
  Mission marvin(testing::named("marvin")), heliv(testing::named("heliv"));

  EXPECT_THAT(marvin.start(rendezvous(1)), ::testing::Contains("sync 551 to heliv"));
  heliv.sync_from("marvin");
  EXPECT_THAT(heliv.start(rendezvous(41)), ElementsAre("41 scheduled", "41 started", "41 running",
                                                       "sync 551 to marvin", "41 ended"));
  EXPECT_THAT(marvin.sync_from("heliv"), ElementsAre("1 ended"));
}

// ---- with a validity ----

Mission with_validity() {
  Config config = testing::named("marvin");
  config.sync_validity = Duration::seconds(20);
  return Mission(config);
}

TEST(SyncValidity, WhoGivesUpWithdrawsAndWhoHasMetSaysSo) {
  Mission mission = with_validity();

  mission.start(rendezvous(1));
  EXPECT_THAT(mission.at(5).abort(1),
              ElementsAre("1 aborting", "1 aborted", "sync 551 to heliv withdrawn"));
  EXPECT_THAT(mission.at(6).start(rendezvous(2)),
              ElementsAre("2 scheduled", "2 started", "2 running", "sync 551 to heliv"));
  EXPECT_THAT(mission.at(7).sync_from("heliv"), ElementsAre("sync 551 to heliv done", "2 ended"));
}

TEST(SyncValidity, APartnerWhoWithdrewIsNotThere) {
  Mission mission = with_validity();
  mission.at(1).sync_from("heliv");
  mission.at(2).give(SyncReceived{551, "heliv", SyncWord::kWithdrawn});

  EXPECT_THAT(mission.at(3).start(rendezvous(1)),
              ElementsAre("1 scheduled", "1 started", "1 running", "sync 551 to heliv"));
  EXPECT_THAT(mission.at(4).sync_from("heliv"), ElementsAre("sync 551 to heliv done", "1 ended"));
}

TEST(SyncValidity, OneOfTwoPartnersMayWithdrawBeforeTheOtherComes) {
  Mission mission = with_validity();
  mission.start(meeting(1, {"marvin", "heliv", "karma"}, {"marvin"}));
  mission.at(1).sync_from("heliv");
  mission.at(2).give(SyncReceived{551, "heliv", SyncWord::kWithdrawn});

  EXPECT_THAT(mission.at(3).sync_from("karma"), IsEmpty());
  EXPECT_THAT(mission.at(4).sync_from("heliv"), ElementsAre("1 ended"));
}

TEST(SyncValidity, WhatWasSaidTooLongAgoDoesNotCountUnlessItIsDone) {
  for (const SyncWord word : {SyncWord::kThere, SyncWord::kDone}) {
    Mission mission = with_validity();
    mission.at(1).give(SyncReceived{551, "heliv", word});

    mission.at(22).start(rendezvous(1));

    EXPECT_EQ(mission.state_of(1), word == SyncWord::kDone ? kEnded : kRunning);
  }
}

TEST(SyncValidity, WhatIsOverAlreadyIsNotWaitedForAndThatIsSaid) {
  Mission mission = with_validity();
  mission.start(rendezvous(1));
  mission.at(1).give(SyncReceived{551, "heliv", SyncWord::kDone});
  EXPECT_THAT(mission.notices, IsEmpty());

  mission.at(22).start(rendezvous(2));

  EXPECT_EQ(mission.state_of(2), kEnded);
  EXPECT_THAT(mission.notices, ElementsAre("task 2: synchronisation 551 is over already, and is "
                                           "not waited for again"));
}

TEST(SyncValidity, AMessageThatWasLongOnItsWayIsAsOldAsItIs) {
  Mission mission = with_validity();
  mission.start(rendezvous(1));

  mission.at(25).give(SyncReceived{551, "heliv", SyncWord::kThere, MissionTime::seconds(1)});

  EXPECT_EQ(mission.state_of(1), kRunning);
}

TEST(SyncValidity, WhatWasSaidBeforeAnotherChangesNothing) {
  Mission mission = with_validity();
  mission.at(8).give(SyncReceived{551, "heliv", SyncWord::kWithdrawn, MissionTime::seconds(7)});
  mission.at(9).give(SyncReceived{551, "heliv", SyncWord::kThere, MissionTime::seconds(2)});

  mission.at(10).start(rendezvous(1));

  EXPECT_EQ(mission.state_of(1), kRunning);
}

TEST(SyncValidity, WhoWaitsSaysSoAgainAtHalfOfIt) {
  Mission mission = with_validity();
  mission.start(rendezvous(1));

  ASSERT_EQ(mission.executive.next_wakeup(), MissionTime::seconds(10));
  EXPECT_THAT(mission.at(10).tick(), ElementsAre("sync 551 to heliv"));
  EXPECT_THAT(mission.at(20).tick(), ElementsAre("sync 551 to heliv"));
  mission.abort(1);
  EXPECT_EQ(mission.executive.next_wakeup(), std::nullopt);
}

TEST(SyncValidity, ASignalIsDoneWhenItIsGivenAndIsNotTakenBack) {
  Mission mission = with_validity();

  EXPECT_THAT(
      mission.start(meeting(1, {"marvin"}, {"heliv"})),
      ElementsAre("1 scheduled", "1 started", "1 running", "sync 551 to heliv done", "1 ended"));
  EXPECT_THAT(mission.suppress(1), IsEmpty());
}

TEST(SyncValidity, WhoComesBackInReachHearsTheLastWord) {
  Mission mission = with_validity();
  mission.start(rendezvous(1));
  EXPECT_THAT(mission.reachable("heliv"), ElementsAre("sync 551 to heliv"));
  mission.sync_from("heliv");
  EXPECT_THAT(mission.reachable("heliv"), ElementsAre("sync 551 to heliv done"));

  Mission other = with_validity();
  other.start(rendezvous(1));
  other.abort(1);
  EXPECT_THAT(other.reachable("heliv"), ElementsAre("sync 551 to heliv withdrawn"));
}

TEST(SyncValidity, AnotherExecutiveThatTakesTheTaskOverIsThereInItsPlace) {
  Mission mission = with_validity();
  mission.start(rendezvous(1));

  EXPECT_THAT(mission.give(Relinquish{}), IsEmpty());
}

TEST(Synchronise, SaysForWhomItHasWaitedAndSinceWhen) {
  Mission mission;
  mission.at(10).start(meeting(1, {"heliv", "karma"}, {"marvin"}));
  mission.at(20).start(meeting(2, {"karma"}, {"marvin"}));
  mission.at(30).sync_from("heliv");

  const std::vector<Wait> waits = mission.executive.waits();
  ASSERT_THAT(waits, SizeIs(2));
  EXPECT_EQ(waits[0].since, MissionTime::seconds(10));
  EXPECT_THAT(waits[0].awaited, ElementsAre("karma"));
  EXPECT_EQ(waits[1].id, TaskId(2));
  mission.sync_from("karma");
  EXPECT_THAT(mission.executive.waits(), IsEmpty());
}

TEST(Synchronise, AWaitThatIsGivenUpIsAbortedForThatReason) {
  Mission mission;
  mission.start(rendezvous(1));

  EXPECT_THAT(mission.give_up(1, "no contact with 'heliv' since 3 s"),
              ElementsAre("1 aborting", "1 aborted"));
  EXPECT_EQ(mission.reason_of(1), "no contact with 'heliv' since 3 s");
  EXPECT_EQ(mission.executive.find(TaskId{1})->cause, AbortCause::kOther);
}

TEST(Synchronise, OnlyAWaitIsGivenUp) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.runs(1);
  mission.start(rendezvous(2));
  mission.sync_from("heliv");

  for (const std::uint64_t id : {1, 2, 3}) EXPECT_THAT(mission.give_up(id, "why"), IsEmpty()) << id;
}

}  // namespace
}  // namespace skein::executive
