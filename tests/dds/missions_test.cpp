// SPDX-License-Identifier: Apache-2.0
// Missions over real DDS meet every expectation: COMETS, a joint task.
#include <gmock/gmock.h>

#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Over DDS a message has a delay of the wall clock, which the rate multiplies: this one leaves the
// deadlines of the scenario a margin on a machine that does other things too.
constexpr const char* kRate = "40";

TEST(DdsMission, ConfirmedAtDegree3MeetsEveryExpectation) {
  DdsRun run;
  run.take_scenario("confirmed");

  run.start({"--rate", kRate, "--degree", "3"});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0);
  EXPECT_THAT(run.output(), HasSubstr("20 of 20 expectations met"));
  EXPECT_EQ(run.count("process", "state", "ready"), 5U);
  EXPECT_EQ(run.count("process", "state", "exited"), 5U);
  EXPECT_EQ(run.count("dropped", "kind", "dropped"), 0U);
  EXPECT_TRUE(run.nothing_runs());
  EXPECT_THAT(run.left_in_shared_memory(), IsEmpty());
  for (const char* name : {"report.html", "junit.xml", "result.json", "logs/marvin.log"}) {
    EXPECT_TRUE(fs::exists(run.folder() / name)) << name;
  }
}

TEST(DdsMission, InfirmedWithMixedDegreesMeetsEveryExpectation) {
  DdsRun run;
  run.take_scenario("infirmed");

  run.start({"--rate", kRate, "--degree", "2", "--degree", "marvin=1", "--degree", "karma=3"});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0);
  EXPECT_THAT(run.output(), HasSubstr("14 of 14 expectations met"));
  EXPECT_TRUE(run.nothing_runs());
}

TEST(DdsMission, AJointTaskIsNegotiatedAndPlayed) { expect_all_met("mref/nominal", "20"); }

TEST(DdsMission, TheGroundStationPlaysARoleForOneAtDegreeTwo) {
  expect_all_met("mref/ground-plays", "20");
}

// Orders, plans, telemetry and perceptions of a UAV that the ground station does not hear.
TEST(DdsMission, WhoIsOutOfReachIsHeardPastARelay) { expect_all_met("relaying/one-relay", "20"); }

TEST(DdsMission, PlacesToLookFromAreAgreedUponInFlight) {
  expect_all_met("agreed-places/around", "20");
}

}  // namespace
}  // namespace skein::testing
