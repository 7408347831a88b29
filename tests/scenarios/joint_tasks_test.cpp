// SPDX-License-Identifier: Apache-2.0
// The reference example (spec 7.7, 8.6) and what may befall it, over many seeds: each draws other
// winds, speeds, delays, losses and sensor noise.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/laws/protocol.hpp"
#include "test_cases.hpp"
#include "testing/deliberation_laws.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

class JointTask : public ::testing::TestWithParam<std::string> {};

TEST_P(JointTask, MeetsEveryExpectationAndKeepsTheLawsWhateverTheSeed) {
  const auto seeds = cases<std::uint64_t>(2, 500);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Mission mission = play(scenario_at("mref/" + GetParam(), with(seed)));

    EXPECT_EQ(mission.end, End::kFinished) << "seed " << seed;
    EXPECT_EQ(mission.failures(), "") << "seed " << seed;
    EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "") << "seed " << seed;
    EXPECT_EQ(mission.untrue, "") << "seed " << seed;
  }
}

TEST_P(JointTask, IsTheSameByteForByteForOneSeed) {
  const std::string once = play(scenario_at("mref/" + GetParam(), with(1))).log();
  const std::string again = play(scenario_at("mref/" + GetParam(), with(1))).log();

  EXPECT_TRUE(once == again);
}

std::string name_of(const ::testing::TestParamInfo<std::string>& one) {
  std::string name = one.param;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Mref, JointTask,
                         ::testing::Values("nominal", "small-move", "larger-move",
                                           "very-large-move", "relay-lost", "radio-cut",
                                           "interrupted", "taken-in-hand"),
                         name_of);

}  // namespace
}  // namespace skein::testing
