// SPDX-License-Identifier: Apache-2.0
// A second process with the name of a UAV in mid-mission: the event log stays the first's, and the
// doctor tells who they are.
#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <string>

#include "skein/blackboard/domain_lease.hpp"
#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using run_tool::Process;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSubsetOf;
using ::testing::Not;

class DdsRivals : public ::testing::TestWithParam<std::string> {
 protected:
  /// On the same machine, with a state folder of its own.
  Process second_karma() const {
    auto process =
        Process::start({kPrograms + "/skein-ddn", "--scenario", run.file("scenario.yaml").string(),
                        "--domain", std::to_string(lease_.domain()), "--dds", GetParam(), "--uav",
                        "karma", "--state", run.file("state-of-second").string()},
                       run.file("second.log").string());
    EXPECT_TRUE(process.has_value());
    return std::move(*process);
  }
  std::string domain() const { return std::to_string(lease_.domain()); }
  /// What the runner has written of two processes named karma.
  std::size_t named_by_runner() const {
    const auto records = run.records();
    return static_cast<std::size_t>(std::ranges::count_if(records, [](const auto& record) {
      return record.kind() == "dropped" && record.node() == "runner" &&
             record.text("origin") == "karma" && record.text("field") == "header.incarnation";
    }));
  }
  /// "TaskEvent 7": the events from karma to the ground station, as one of the two logged them.
  std::set<std::string> events_of_karma(const std::string& node,
                                        const std::string& direction) const {
    std::set<std::string> all;
    for (const journal::Record& record : run.records())
      if (record.kind() == "message" && record.node() == node &&
          record.text("direction") == direction && record.text("from") == "karma" &&
          record.text("to") == "ground")
        all.insert(std::string(record.text("slot")) + " " +
                   std::to_string(record.number("sequence")));
    return all;
  }
  std::size_t ended_tasks() const {
    const auto records = run.records();
    return static_cast<std::size_t>(std::ranges::count_if(records, [](const auto& record) {
      return record.kind() == "task" && record.node() == "karma" && record.text("state") == "ended";
    }));
  }

  DdsRun run;

 private:
  blackboard::DomainLease lease_ = blackboard::claim_domain().value();
};

TEST_P(DdsRivals, TheEventLogMissesNothingThatTheFirstSays) {
  run.take_scenario("confirmed");
  run.start({"--rate", "15", "--domain", domain(), "--dds", GetParam()});
  run.wait_for_output("the mission starts");
  const Process second = second_karma();

  const Answered doctor = run.skein({"spy", "--duration", "6", "doctor"});
  EXPECT_THAT(doctor.text, HasSubstr("2 programs say that they are karma: process "));
  EXPECT_THAT(doctor.text, HasSubstr("process " + std::to_string(second.pid()) + " at 127.0.0.1:"));
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0) << run.output();
  EXPECT_THAT(run.output(), HasSubstr("20 of 20 expectations met"));
  EXPECT_GE(named_by_runner(), 1U);
  const auto received = events_of_karma("ground", "received");
  EXPECT_THAT(received, Not(IsEmpty()));
  EXPECT_THAT(received, IsSubsetOf(events_of_karma("karma", "sent")));
  EXPECT_EQ(ended_tasks(), 4U) << "take-off, the way there, the way back and the landing";
}

INSTANTIATE_TEST_SUITE_P(OverDds, DdsRivals, ::testing::Values("fastdds", "cyclonedds"),
                         [](const auto& one) { return "on_" + one.param; });

}  // namespace
}  // namespace skein::testing
