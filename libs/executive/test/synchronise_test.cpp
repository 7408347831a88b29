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

  EXPECT_THAT(mission.start(TaskOf(1, "rendezvous").among({"marvin", "heliv"}, {"heliv", "marvin"})),
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

}  // namespace
}  // namespace skein::executive
