// SPDX-License-Identifier: Apache-2.0
// A run that comes to no end says which step waits for what, and why that does not come.
#include "skein/laws/waiting.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/journal/lines/mission.hpp"

namespace skein::laws {
namespace {

using executive::TaskId;
using executive::TaskState;
using ground_station::Action;
using ground_station::AllOf;
using ground_station::AnyOf;
using ground_station::OnTask;
using ground_station::Trigger;
using journal::Record;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Heliv is asked to wait (24); an operator ends that, which brings it home (32), and that the
/// mission.
scenario::Scenario waits_and_comes_home() {
  const auto asks = [](std::uint64_t task) {
    ground_station::SendPlan plan{"heliv", {{}}};
    plan.tasks[0].task.id = TaskId(task);
    return Action{plan};
  };
  const auto on = [](std::uint64_t task) {
    return Trigger{OnTask{"heliv", TaskId(task), TaskState::kEnded}};
  };
  scenario::Scenario scenario;
  auto& script = scenario.ground.script;
  const Trigger at_once{ground_station::AtTime{}};
  const Trigger silent{ground_station::OnSilence{"heliv", Duration::seconds(180)}};
  script.steps.push_back({"begin", "", at_once, {}, {asks(24)}});
  script.steps.push_back(
      {"return", "", {AnyOf{{{ground_station::OnOperator{"enough"}}, silent}}}, {}, {asks(32)}});
  script.steps.push_back({"end", "", {AllOf{{at_once, on(32)}}}, {}, {ground_station::Finish{}}});
  script.operators.push_back({"enough", on(24), {}, {}});
  return scenario;
}

Record line(double at, const char* kind) { return {MissionTime::seconds(at), "ground", kind}; }

Record task(double at, int id, const char* state, const char* reason = "") {
  Record record = line(at, "task");
  record.with("uav", "heliv").with("task", id).with("state", state);
  return *reason == 0 ? record : record.with("reason", reason);
}

Record begun() { return line(0, "step").with("name", "begin"); }

std::vector<std::string> texts(const std::vector<Record>& records) {
  std::vector<std::string> sentences;
  for (const Waiting& one : waits_of(waits_and_comes_home(), records))
    sentences.push_back(to_text(one));
  return sentences;
}

TEST(Waits, GoBackFromTheEndToWhatWasInterruptedAndByWhat) {
  const std::vector<Record> records{begun(), task(10, 24, "running"),
                                    line(60, "contact").with("uav", "heliv").with("policy", "hold"),
                                    task(60, 24, "aborting", "displaced by urgent task 1000060000"),
                                    task(62, 24, "aborted", "interrupted")};

  EXPECT_THAT(texts(records),
              ElementsAre("step end waits for task 32 of heliv ended: never begun",
                          "step return waits for operator enough: not done",
                          "operator enough waits for task 24 of heliv ended: aborted since 62.0 s "
                          "(its contact-loss policy hold at 60.0 s; displaced by urgent task "
                          "1000060000)"));
}

TEST(Waits, NameTheCommandThatExpired) {
  const std::vector<Record> records{begun(), line(65, "command")
                                                 .with("uav", "heliv")
                                                 .with("what", "START 24 wait")
                                                 .with("state", "expired")
                                                 .with("why", "no answer")};

  ASSERT_THAT(texts(records), SizeIs(3));
  EXPECT_THAT(texts(records)[2],
              HasSubstr("never begun since 65.0 s (START 24 wait expired: no answer)"));
}

TEST(Waits, WhatHasComeAboutIsNotNamed) {
  const std::vector<Record> records{
      begun(), task(10, 24, "ended"), line(40, "operator").with("does", "enough"),
      line(40, "step").with("name", "return"), task(50, 32, "running")};

  EXPECT_THAT(texts(records),
              ElementsAre("step end waits for task 32 of heliv ended: running since 50.0 s"));
}

TEST(Waits, AMissionThatWasFinishedHasNone) {
  EXPECT_THAT(texts({begun(), line(50, "mission").with("state", "finished")}), IsEmpty());
}

TEST(Waits, AreLinesOfTheEventLog) {
  const auto lines =
      waiting_lines(waits_of(waits_and_comes_home(), {begun()}), MissionTime::seconds(99));

  ASSERT_THAT(lines, SizeIs(3));
  EXPECT_EQ(lines[0].kind(), "waiting");
  EXPECT_EQ(lines[0].node(), "runner");
  EXPECT_EQ(lines[0].at(), MissionTime::seconds(99));
  EXPECT_EQ(lines[0].text("step"), "step end");
  EXPECT_EQ(lines[0].text("for"), "task 32 of heliv ended");
  EXPECT_EQ(lines[0].text("is"), "never begun");
}

}  // namespace
}  // namespace skein::laws
