// SPDX-License-Identifier: Apache-2.0
// Tasks that the supervisor carries out, and the routine that fills in. Source: spec 2.6.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/mission.hpp"

namespace skein::executive {
namespace {

using testing::cm;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::Mission;
using testing::TaskOf;
using enum TaskState;
using enum InsertionMode;

// --- joint tasks ---

TEST(JointTask, IsHandedToTheSupervisorOnceItsPreconditionsHold) {
  Mission mission;
  mission.start(TaskOf(1, "joint:track").pre({cm("go")}));

  EXPECT_THAT(mission.message("go"), ElementsAre("1 started", "dispatch joint 1"));
}

TEST(JointTask, FollowsTheStatesThatTheSupervisorReports) {
  Mission mission;
  mission.start(TaskOf(1, "joint:track"));

  EXPECT_THAT(mission.runs(1), ElementsAre("1 running"));
  EXPECT_THAT(mission.ends(1), ElementsAre("1 ended"));
}

TEST(JointTask, IsInterruptedThroughTheSupervisor) {
  Mission mission;
  mission.start(TaskOf(1, "joint:track").exit({cm("stop")}));

  EXPECT_THAT(mission.message("stop"), ElementsAre("1 aborting", "interrupt joint 1"));
  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted"));
}

TEST(JointTask, HasTheStatusesOfEveryOtherTaskForwardedWhileItIsUnderWay) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "joint:track"));
  mission.runs(2);

  EXPECT_THAT(mission.runs(1), ElementsAre("1 running", "forward 1 running"));
  EXPECT_THAT(mission.abort(1), ElementsAre("1 aborting", "forward 1 aborting", "interrupt 1"));
}

TEST(JointTask, HasNothingForwardedBeforeItsDispatchNorAfterItsEnd) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "joint:track").pre({cm("go")}));

  EXPECT_THAT(mission.runs(1), ElementsAre("1 running"));
  mission.message("go");
  EXPECT_THAT(mission.ends(2), ElementsAre("2 ended"));
  EXPECT_THAT(mission.ends(1), ElementsAre("1 ended"));
}

TEST(JointTask, HasTheStatusesOfAnotherJointTaskForwarded) {
  Mission mission;
  mission.start(TaskOf(1, "joint:track"));
  mission.start(TaskOf(2, "joint:survey"));

  EXPECT_THAT(mission.ends(1), ElementsAre("1 ended", "forward 1 ended"));
  EXPECT_THAT(mission.ends(2), ElementsAre("2 ended"));
}

TEST(JointTask, IsNotUnderTheFunctionalTimeOut) {
  Config config = testing::named("marvin");
  config.functional_timeout = Duration::seconds(1);
  Mission mission(config);
  mission.start(TaskOf(1, "joint:track"));

  EXPECT_EQ(mission.executive.next_wakeup(), std::nullopt);
  EXPECT_THAT(mission.at(100).tick(), IsEmpty());
}

TEST(JointTask, IsAnyTypeWithThePrefix) {
  EXPECT_TRUE(is_joint("joint:track"));
  EXPECT_FALSE(is_joint("track"));
  EXPECT_FALSE(is_joint("a joint:track"));
}

// --- background routine ---

const std::string kFirst = to_text(kFirstBackgroundId);
const std::string kSecond = to_text(TaskId{kFirstBackgroundId.value() + 1});

Config with_routine() {
  Config config = testing::named("marvin");
  config.background_type = "wait";
  return config;
}

TEST(BackgroundRoutine, IsDispatchedWhenTheVehicleFliesAndNothingMovesIt) {
  Mission mission(with_routine());

  EXPECT_THAT(mission.flies(),
              ElementsAre(kFirst + " scheduled", kFirst + " started", "dispatch " + kFirst));
  EXPECT_EQ(mission.executive.find(kFirstBackgroundId)->type, "wait");
}

TEST(BackgroundRoutine, IsOffUnlessConfigured) {
  Mission mission;

  EXPECT_THAT(mission.flies(), IsEmpty());
}

TEST(BackgroundRoutine, BeginsAfterTakeoffAndStopsMatteringAfterLanding) {
  Mission mission(with_routine());
  mission.start(TaskOf(1, "takeoff"));

  EXPECT_THAT(mission.ends(1), ElementsAre("1 ended", kFirst + " scheduled", kFirst + " started",
                                           "dispatch " + kFirst));
  mission.start(TaskOf(2, "land"));
  mission.aborted(kFirstBackgroundId.value());
  EXPECT_THAT(mission.ends(2), ElementsAre("2 ended"));
}

TEST(BackgroundRoutine, WaitsWhileAMotionTaskIsUnderWayOrAborting) {
  Mission mission(with_routine());
  mission.start(TaskOf(1, "goto"));

  EXPECT_THAT(mission.flies(), IsEmpty());
  EXPECT_THAT(mission.abort(1), ElementsAre("1 aborting", "interrupt 1"));
  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted", kFirst + " scheduled",
                                              kFirst + " started", "dispatch " + kFirst));
}

TEST(BackgroundRoutine, IsDisplacedByAnyMotionTaskAndComesBackAfterIt) {
  Mission mission(with_routine());
  mission.flies();

  EXPECT_THAT(mission.start(TaskOf(1, "goto")),
              ElementsAre("1 scheduled", kFirst + " aborting", "interrupt " + kFirst, "1 started",
                          "dispatch 1"));
  EXPECT_THAT(mission.aborted(kFirstBackgroundId.value()), ElementsAre(kFirst + " aborted"));
  EXPECT_THAT(mission.ends(1), ElementsAre("1 ended", kSecond + " scheduled", kSecond + " started",
                                           "dispatch " + kSecond));
}

TEST(BackgroundRoutine, GivesWayToARendezvousWhichNeedsTheVehicleWhereItIs) {
  Mission mission(with_routine());
  mission.flies();

  EXPECT_THAT(mission.start(TaskOf(1, "rendezvous").among({"marvin", "heliv"}, {"marvin"})),
              ElementsAre("1 scheduled", kFirst + " aborting", "interrupt " + kFirst, "1 started",
                          "1 running"));
  EXPECT_THAT(mission.aborted(kFirstBackgroundId.value()), ElementsAre(kFirst + " aborted"));
  EXPECT_THAT(mission.sync_from("heliv"), ElementsAre("1 ended", kSecond + " scheduled",
                                                      kSecond + " started", "dispatch " + kSecond));
}

TEST(BackgroundRoutine, LetsATaskThatDoesNotMoveTheVehicleBe) {
  Mission mission(with_routine());
  mission.flies();

  EXPECT_THAT(mission.start(TaskOf(1, "takeshot")),
              ElementsAre("1 scheduled", "1 started", "dispatch 1"));
}

TEST(BackgroundRoutine, IsWaitedForByAnUrgentMotionTask) {
  Mission mission(with_routine());
  mission.flies();

  EXPECT_THAT(mission.start(TaskOf(1, "land"), kVut),
              ElementsAre("1 scheduled", kFirst + " aborting", "interrupt " + kFirst));
  EXPECT_THAT(mission.aborted(kFirstBackgroundId.value()),
              ElementsAre(kFirst + " aborted", "1 started", "dispatch 1"));
}

TEST(BackgroundRoutine, HoldsBackForAnUrgentMotionTaskUntilThatIsCancelled) {
  Mission mission(with_routine());
  mission.start(TaskOf(1, "goto"));
  mission.flies();
  mission.start(TaskOf(2, "land"), kVut);
  mission.abort(2);

  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted", kFirst + " scheduled",
                                              kFirst + " started", "dispatch " + kFirst));
}

TEST(BackgroundRoutine, IsNotAPredecessorOfDepAndNut) {
  Mission mission(with_routine());
  mission.flies();

  mission.start(TaskOf(1, "takeshot").exit({}), kDep);

  EXPECT_EQ(mission.state_of(1), kStarted);
}

TEST(BackgroundRoutine, IsBeyondTheReachOfRequests) {
  Mission mission(with_routine());
  mission.flies();
  const std::uint64_t id = kFirstBackgroundId.value();

  EXPECT_THAT(mission.abort(id), ElementsAre("refused ABORT"));
  EXPECT_THAT(mission.suppress(id), ElementsAre("refused SUPPRESS"));
  EXPECT_THAT(mission.update(id, {}, Formula{}), ElementsAre("refused UPDATE-COND"));
  EXPECT_THAT(mission.start(TaskOf(1, "goto").pre({testing::ce(id, kEnded)})),
              ElementsAre("1 aborted"));
}

TEST(BackgroundRoutine, IsInterruptedWhenTheVehicleIsNoLongerInFlight) {
  Mission mission(with_routine());
  mission.flies();

  EXPECT_THAT(mission.flies(false), ElementsAre(kFirst + " aborting", "interrupt " + kFirst));
  EXPECT_THAT(mission.aborted(kFirstBackgroundId.value()), ElementsAre(kFirst + " aborted"));
}

TEST(BackgroundRoutine, IsTriedAgainAfterAWhileWhenItIsRefused) {
  Mission mission(with_routine());
  mission.flies();

  EXPECT_THAT(mission.aborted(kFirstBackgroundId.value()), ElementsAre(kFirst + " aborted"));
  EXPECT_EQ(mission.executive.next_wakeup(), MissionTime::seconds(5));
  EXPECT_THAT(mission.at(5).tick(),
              ElementsAre(kSecond + " scheduled", kSecond + " started", "dispatch " + kSecond));
}

TEST(BackgroundRoutine, LeavesNoTraceInThePlanOnceOver) {
  Mission mission(with_routine());
  mission.flies();
  mission.flies(false);

  mission.aborted(kFirstBackgroundId.value());

  EXPECT_THAT(mission.executive.tasks(), IsEmpty());
}

}  // namespace
}  // namespace skein::executive
