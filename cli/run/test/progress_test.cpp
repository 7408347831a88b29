// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace skein::run_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

journal::Record task(const std::string& uav, int id, const std::string& type,
                     const std::string& state) {
  return journal::Record(at(1), uav, "task")
      .with("uav", uav)
      .with("task", id)
      .with("type", type)
      .with("state", state);
}

class ProgressLines : public ::testing::Test {
 protected:
  std::ostringstream out;
  Progress progress{out, Progress::Style::kLines, {"marvin", "heliv"}};

  std::string shown(double seconds) {
    out.str("");
    progress.show(at(seconds));
    return out.str();
  }
};

TEST_F(ProgressLines, ShowTimePhaseAndEachUavsTasks) {
  progress.see(journal::Record(at(1), "ground", "phase").with("name", "Detection"));
  progress.see(task("marvin", 3, "goto", "running"));
  progress.see(task("marvin", 4, "takeshot", "started"));

  EXPECT_EQ(shown(65), "0:01:05  Detection  | marvin goto 3 + takeshot 4  | heliv idle\n");
}

TEST_F(ProgressLines, BeforeAnythingHappensShowThatNothingDoes) {
  EXPECT_EQ(shown(0), "0:00:00  -  | marvin idle  | heliv idle\n");
}

TEST_F(ProgressLines, ComeOnlyWhenSomethingChanged) {
  shown(0);

  EXPECT_EQ(shown(10), "");
  progress.see(task("heliv", 1, "takeoff", "running"));
  EXPECT_THAT(shown(20), HasSubstr("heliv takeoff 1"));
  EXPECT_EQ(shown(21), "");
}

TEST_F(ProgressLines, AreNotChangedByRecordsOfOtherKinds) {
  shown(0);

  progress.see(journal::Record(at(1), "sim", "telemetry").with("uav", "marvin"));

  EXPECT_EQ(shown(1), "");
}

TEST_F(ProgressLines, SayAtOnceThatAMissionIsRefusedAndWhy) {
  progress.see(journal::Record(at(18), "ground", "global-mission")
                   .with("mission", 1)
                   .with("state", "refused")
                   .with("why", "tasks 11, 12: the last cannot end before 40 s"));

  EXPECT_EQ(
      out.str(),
      "0:00:18  global mission 1 is refused: tasks 11, 12: the last cannot end before 40 s\n");
}

TEST_F(ProgressLines, SayAtOnceAndOnceThatNobodyCanDoATaskAndWhy) {
  const auto owner = [](int second, const char* stage, const char* why) {
    return journal::Record(at(second), "ground", "owner")
        .with("task", 31)
        .with("statement", "perform-mapping field")
        .with("stage", stage)
        .with("why", why);
  };
  progress.see(owner(40, "for-sale", ""));
  progress.see(owner(41, "unsold", "marvin: no device; heliv: no device"));
  progress.see(owner(101, "for-sale", "called again"));
  progress.see(owner(102, "unsold", "marvin: no device; heliv: no device"));

  EXPECT_EQ(out.str(),
            "0:00:41  task 31 (perform-mapping field) has no owner: "
            "marvin: no device; heliv: no device\n");
}

class TaskStates : public ProgressLines, public ::testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(Shown, TaskStates, ::testing::Values("started", "running", "aborting"));

TEST_P(TaskStates, ThatAreUnderWayAreShown) {
  progress.see(task("marvin", 3, "goto", GetParam()));

  EXPECT_THAT(shown(1), HasSubstr("goto 3"));
}

class OverStates : public ProgressLines, public ::testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(Hidden, OverStates, ::testing::Values("scheduled", "ended", "aborted"));

TEST_P(OverStates, AreNotShown) {
  progress.see(task("marvin", 3, "goto", "running"));

  progress.see(task("marvin", 3, "goto", GetParam()));

  EXPECT_THAT(shown(1), Not(HasSubstr("goto 3")));
}

TEST_F(ProgressLines, AUavThatIsNotOfTheScenarioIsNotShown) {
  progress.see(task("stranger", 3, "goto", "running"));

  EXPECT_THAT(shown(1), Not(HasSubstr("goto")));
}

TEST_F(ProgressLines, AMessageHasItsOwnLine) {
  progress.say("all nodes are ready");

  EXPECT_EQ(out.str(), "all nodes are ready\n");
}

TEST(ProgressOnATerminal, WritesOverItsOneLine) {
  std::ostringstream out;
  Progress progress(out, Progress::Style::kTerminal, {"marvin"});

  progress.show(at(1));
  progress.show(at(2));

  EXPECT_THAT(out.str(), Not(HasSubstr("\n")));
  EXPECT_THAT(out.str(), HasSubstr("\r\033[K"));
  EXPECT_THAT(out.str(), HasSubstr("0:00:02"));
}

TEST(ProgressOnATerminal, LeavesAnEmptyLineBehind) {
  std::ostringstream out;
  Progress progress(out, Progress::Style::kTerminal, {"marvin"});
  progress.show(at(1));

  progress.finish();

  EXPECT_THAT(out.str(), ::testing::EndsWith("\r\033[K"));
}

TEST(ProgressOff, WritesNothing) {
  std::ostringstream out;
  Progress progress(out, Progress::Style::kNone, {"marvin"});

  progress.see(task("marvin", 3, "goto", "running"));
  progress.show(at(1));
  progress.say("hello");
  progress.finish();

  EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace skein::run_tool
