// SPDX-License-Identifier: Apache-2.0
// A run without words: played, judged, kept.
#include "skein/run_tool/whole_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <sstream>

#include "skein/assembly/assembly.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/run_tool/interrupt_guard.hpp"
#include "skein/run_tool/run.hpp"
#include "testing/scenario_copy.hpp"

namespace skein::run_tool {
namespace {

using testing::Folder;
using testing::read_text;

const std::string kDetection = SKEIN_SOURCE_DIR "/scenarios/karma/detection.yaml";

TEST(WholeRun, LeavesWhatTheCommandLeaves) {
  const Folder folder;
  const auto scenario = assembly::load_scenario(kDetection, {});
  ASSERT_TRUE(scenario.has_value());
  RunOptions options;
  options.scenario = kDetection;
  options.virtual_time = true;
  options.out = (folder / "command").string();
  std::ostringstream out, err;
  run(options, out, err);

  const WholeRun whole = play_whole(*scenario);
  ASSERT_TRUE(
      keep_run((folder / "kept").string(), *scenario, read_text(kDetection), whole).has_value());

  EXPECT_EQ(exit_code_of(whole), kExitOk);
  for (const char* name : {"events.jsonl", "run.json", "result.json", "scenario.yaml"}) {
    EXPECT_EQ(read_text(folder / "command" / name), read_text(folder / "kept" / name)) << name;
  }
}

TEST(WholeRun, ThatDidNotEndAndExpectsNothingHasNotPassed) {
  WholeRun whole;
  whole.played.end = Played::End::kTimeLimit;

  EXPECT_EQ(exit_code_of(whole), kExitNegative);
  EXPECT_TRUE(ended_unjudged(whole));
}

TEST(WholeRun, WhoseExpectationIsNotMetHasNotPassed) {
  scenario::Scenario scenario;
  scenario.expectations = {{"a task", scenario::ExpectEvent{{{{"kind", {"task"}}}}, {}, 1, {}}}};

  const WholeRun whole = judged(scenario, {});

  EXPECT_EQ(exit_code_of(whole), kExitNegative);
  ASSERT_EQ(whole.played.records.size(), 1U);
  EXPECT_EQ(whole.played.records[0].kind(), "expectation");
}

TEST(InterruptGuard, WhatIsToOutliveItsTerminalDoes) {
  const auto before = std::signal(SIGHUP, SIG_IGN);  // as nohup does
  {
    const InterruptGuard guard;
    std::raise(SIGHUP);
    EXPECT_FALSE(InterruptGuard::interrupted());
  }
  std::signal(SIGHUP, before);
}

TEST(InterruptGuard, RemembersThatItWasAskedForAndNothingOfBefore) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const InterruptGuard guard;
    EXPECT_FALSE(InterruptGuard::interrupted());
    std::raise(signal);
    EXPECT_TRUE(InterruptGuard::interrupted());
  }

  const InterruptGuard guard;
  EXPECT_FALSE(InterruptGuard::interrupted());
}

}  // namespace
}  // namespace skein::run_tool
