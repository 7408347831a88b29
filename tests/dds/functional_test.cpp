// SPDX-License-Identifier: Apache-2.0
// Functional layers as programs of their own, over real DDS.
#include <gmock/gmock.h>

#include "skein/blackboard/domain_lease.hpp"
#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kHeliv = "heliv: {model:";
constexpr const char* kHelivElsewhere = "heliv: {functional: autopilot, model:";

TEST(DdsFunctional, TheCometsMissionWithALayerOfItsOwnMeetsEveryExpectation) {
  DdsRun run;
  run.take_scenario("confirmed");
  run.change(kHeliv, kHelivElsewhere);

  run.start({"--rate", "40"});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0) << run.output();
  EXPECT_THAT(run.output(), HasSubstr("20 of 20 expectations met"));
  EXPECT_EQ(run.count("process", "state", "ready"), 6U);
  for (const journal::Record& line : run.records()) {
    if (line.kind() != "functional") continue;
    EXPECT_EQ(line.node(), line.text("uav") == "heliv" ? "autopilot" : "sim");
  }
  EXPECT_TRUE(run.nothing_runs());
  EXPECT_THAT(run.left_in_shared_memory(), IsEmpty());
}

std::optional<run_tool::Process::Status> end_of(run_tool::Process& process, double seconds) {
  holds_within(seconds, [&] { return process.poll().has_value(); });
  return process.poll();
}

TEST(DdsFunctional, ALayerIsCheckedAgainstItsContract) {
  DdsRun files;
  files.take_scenario("confirmed");
  files.change(kHeliv, kHelivElsewhere);
  const std::string scenario = files.file("scenario.yaml").string();
  const auto lease = blackboard::claim_domain();
  ASSERT_TRUE(lease.has_value());
  const std::string domain = std::to_string(lease->domain());
  auto layer = run_tool::Process::start(
      {kPrograms + "/skein-sim", "--scenario", scenario, "--node", "autopilot", "--domain", domain},
      files.file("layer.log").string());
  ASSERT_TRUE(layer.has_value());

  const std::string log = files.file("check.log").string();
  auto check = run_tool::Process::start({kPrograms + "/skein", "functional", scenario, "--uav",
                                         "heliv", "--domain", domain, "--rate", "20"},
                                        log);
  ASSERT_TRUE(check.has_value());
  const auto status = end_of(*check, 120);

  ASSERT_TRUE(status.has_value()) << run_tool::tail_of(log, 30);
  EXPECT_EQ(status->code, 0) << run_tool::tail_of(log, 30);
  EXPECT_THAT(run_tool::tail_of(log, 30), HasSubstr("points kept by 'autopilot' for heliv"));
  EXPECT_THAT(run_tool::tail_of(log, 30), Not(HasSubstr("NOT")));
  EXPECT_TRUE(end_of(*layer, 30).has_value()) << "the clock has ended";
}

}  // namespace
}  // namespace skein::testing
