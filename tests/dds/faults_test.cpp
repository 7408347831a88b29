// SPDX-License-Identifier: Apache-2.0
// Daemons that die, users that lose patience: the run says so, ends, and leaves nothing behind.
#include <gmock/gmock.h>

#include <algorithm>
#include <csignal>

#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kStarted = "the mission starts";
constexpr const char* kFlying = "marvin takeoff 1";

void expect_nothing_left(DdsRun& run) {
  EXPECT_TRUE(run.nothing_runs());
  EXPECT_THAT(run.left_in_shared_memory(), IsEmpty());
}

TEST(DdsFault, ADaemonKilledInMidMissionEndsTheRunWithThreeAndItsName) {
  DdsRun run;
  run.take_scenario("confirmed");
  run.start();
  run.wait_for_output(kFlying);
  EXPECT_THAT(run.daemons(), ElementsAre("ground", "heliv", "karma", "marvin", "sim"));

  run.kill_daemon("heliv");
  const auto status = run.wait(30);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 3);
  EXPECT_THAT(run.output(), HasSubstr("the run failed: heliv (skein-ddn) died: signal 9"));
  EXPECT_EQ(run.count("process", "state", "crashed"), 1U);
  EXPECT_TRUE(fs::exists(run.folder() / "report.html"));
  expect_nothing_left(run);
}

TEST(DdsFault, TheSimulatorKilledInMidMissionIsNoDifferent) {
  DdsRun run;
  run.take_scenario("confirmed");
  run.start();
  run.wait_for_output(kFlying);

  run.kill_daemon("sim");
  const auto status = run.wait(30);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 3);
  EXPECT_THAT(run.output(), HasSubstr("sim (skein-sim) died: signal 9"));
  expect_nothing_left(run);
}

TEST(DdsFault, AScriptedKillAndRestartIsPartOfTheMission) {
  DdsRun run;
  run.take_scenario("infirmed",
                    "faults: [{at: 30, kill: karma, restart_after: 60, forgets: true}]\n");
  run.start({"--rate", "40"});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0);
  EXPECT_EQ(run.count("fault", "what", "kill"), 1U);
  EXPECT_EQ(run.count("fault", "what", "restart"), 1U);
  // started ready crashed started ready exited
  EXPECT_EQ(run.count("process", "name", "karma"), 6U);
  expect_nothing_left(run);
}

// Every kind of daemon dies in the middle of what it does, the clock's leader among them.
TEST(DdsFault, DaemonsThatComeBackWithWhatTheyKnewGoOnWithTheMission) {
  DdsRun run;
  run.take_scenario("confirmed",
                    "faults:\n"
                    "  - {at: 100, kill: marvin, restart_after: 5}\n"
                    "  - {at: 200, kill: sim, restart_after: 5}\n"
                    "  - {at: 320, kill: ground, restart_after: 5}\n"
                    "  - {at: 400, kill: heliv, restart_after: 5}\n");
  run.start({"--rate", "20"});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  // On a machine so loaded that the ground station takes 30 mission seconds (1.5 s) to come back,
  // the policies of lost contact come in, as they should, and the mission is another.
  const std::vector<journal::Record> all = run.records();
  const bool in_time =
      std::none_of(all.begin(), all.end(), [](const auto& one) { return one.kind() == "contact"; });
  EXPECT_TRUE(!in_time || status->code == 0) << run.output();
  EXPECT_EQ(run.count("fault", "what", "resume"), 4U);
  std::vector<std::string> resumed;
  for (const journal::Record& record : run.records())
    if (record.kind() == "resumed") resumed.push_back(record.node());
  EXPECT_THAT(resumed, ElementsAre("marvin", "sim", "ground", "heliv"));
  expect_nothing_left(run);
}

// A functional layer of its own loses all it knew, in the air; its vehicles are where they are.
TEST(DdsFault, AFunctionalLayerThatForgetsIsAskedAndTheMissionGoesOn) {
  DdsRun run;
  run.take_scenario_of("karma/detection",
                       "\nfaults: [{at: 100, kill: sim, restart_after: 5, forgets: true}]\n");
  run.start({"--rate", "20"});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(run.count("fault", "what", "restart"), 1U);
  std::size_t asked = 0;
  bool down = false;
  for (const journal::Record& record : run.records()) {
    asked += record.text("text").find("came back without its memory") != std::string::npos ? 1 : 0;
    if (record.kind() == "telemetry") down = !record.truth("airborne");
  }
  EXPECT_GE(asked, 1U);
  EXPECT_TRUE(down);
  EXPECT_TRUE(run.nothing_runs());  // who is killed leaves its shared memory behind
}

TEST(DdsFault, CtrlCEndsTheRunWith130) {
  DdsRun run;
  run.take_scenario("confirmed");
  run.start();
  run.wait_for_output(kFlying);

  run.send(SIGINT);
  const auto status = run.wait(30);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 130);
  EXPECT_THAT(run.output(), HasSubstr("interrupted"));
  EXPECT_EQ(run.count("process", "state", "crashed"), 0U);
  EXPECT_TRUE(fs::exists(run.folder() / "report.html"));
  expect_nothing_left(run);
}

TEST(DdsFault, CtrlCBeforeTheMissionStartsEndsTheRunWith130Too) {
  DdsRun run;
  run.take_scenario("confirmed");
  run.start();
  run.wait_until("daemon", [&] { return run.daemons().size() == 5; });

  run.send(SIGINT);
  const auto status = run.wait(30);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 130);
  expect_nothing_left(run);
}

// Not even the runner may be relied upon.
TEST(DdsFault, DaemonsEndWhenTheRunnerIsKilled) {
  DdsRun run;
  run.take_scenario("confirmed");
  run.start();
  run.wait_for_output(kStarted);

  run.send(SIGKILL);
  const auto status = run.wait(30);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->signal, SIGKILL);
  expect_nothing_left(run);
}

TEST(DdsFault, ADaemonThatFailsAtItsStartIsQuoted) {
  DdsRun run;
  run.take_scenario("confirmed");

  run.start({"--daemons", run.programs_with({"skein-ddn"}, "echo no memory >&2; exit 7")});
  const auto status = run.wait(30);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 3);
  EXPECT_THAT(run.output(),
              HasSubstr("(skein-ddn) died: exit code 7; its last lines:\n    no memory"));
  expect_nothing_left(run);
}

}  // namespace
}  // namespace skein::testing
