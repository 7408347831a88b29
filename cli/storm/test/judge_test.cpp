// SPDX-License-Identifier: Apache-2.0
// A scenario is played in a process of its own and judged.
#include "skein/storm_tool/judge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/mission_lab/generate.hpp"

namespace skein::storm_tool {
namespace {

using mission_lab::kClean;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kFile = SKEIN_SOURCE_DIR "/scenarios/comets/drawn.yaml";

std::string text_of(std::uint64_t seed, const mission_lab::Kinds& kinds) {
  return to_yaml(mission_lab::generate(seed, kinds), "..");
}

TEST(Judge, SaysWhatAScenarioCameTo) {
  const Verdict verdict = judge_one({"clean", text_of(2, kClean), kFile}, {});

  EXPECT_TRUE(verdict.valid);
  EXPECT_GT(verdict.goals, 0);
  EXPECT_GT(verdict.flown, 0);
}

TEST(Judge, SaysWhyTextIsNoScenario) {
  const Verdict verdict = judge_one({"wrong", "scenario: [", kFile}, {});

  EXPECT_FALSE(verdict.valid);
  EXPECT_THAT(verdict.problem, HasSubstr("drawn.yaml"));
}

TEST(Judge, FindsNoDifferenceBetweenTwoRunsOfOneSeed) {
  JudgeOptions twice;
  twice.twice = true;

  EXPECT_THAT(judge_one({"clean", text_of(2, kClean), kFile}, twice).violations, IsEmpty());
}

}  // namespace
}  // namespace skein::storm_tool
