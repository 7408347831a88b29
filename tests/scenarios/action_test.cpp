// SPDX-License-Identifier: Apache-2.0
// Helicopters and ground robots that patrol and meet (spec 8.8), over many seeds: each draws other
// winds, speeds, delays and losses. What short cuts of the radio change is compared with the same
// seed without them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "skein/laws/protocol.hpp"
#include "test_cases.hpp"
#include "testing/deliberation_laws.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

class Action : public ::testing::TestWithParam<std::string> {};

std::string judged(const Mission& mission) {
  return (mission.end == End::kFinished ? "" : "it did not finish\n") + mission.failures() +
         laws::to_text(laws::broken_protocol(mission.records)) + mission.untrue;
}

TEST_P(Action, MeetsEveryExpectationAndKeepsTheLawsWhateverTheSeedAndTheCuts) {
  const auto seeds = cases<std::uint64_t>(2, 200);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    scenario::Scenario scenario = scenario_at("action/" + GetParam(), with(seed));
    EXPECT_EQ(judged(play(scenario)), "") << "seed " << seed;
    if (scenario.radio.cuts.empty()) continue;
    scenario.radio.cuts.clear();
    EXPECT_EQ(judged(play(scenario)), "") << "seed " << seed << " without cuts";
  }
}

TEST_P(Action, IsTheSameByteForByteForOneSeed) {
  const std::string once = play(scenario_at("action/" + GetParam(), with(1))).log();

  EXPECT_TRUE(once == play(scenario_at("action/" + GetParam(), with(1))).log());
}

INSTANTIATE_TEST_SUITE_P(Virtual, Action,
                         ::testing::Values("over-the-ridge", "patrol", "patrol-twelve"),
                         [](const auto& one) {
                           std::string name = one.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(ActionDegrees, ARobotDrivesByScriptAtEachDegree) {
  for (const char* degree : {"1", "2", "3"})
    EXPECT_EQ(judged(play(scenario_at("action/by-script", with(1, {degree})))), "") << degree;
}

/// When each goal was achieved [s].
std::map<std::string, double> achieved(const Mission& mission) {
  std::map<std::string, double> at;
  for (const auto& record : mission.find({{"kind", "goal"}, {"state", "achieved"}}))
    at[std::string(record.text("uav")) + " " +
       std::to_string(static_cast<int>(record.number("goal")))] = record.at().to_seconds();
  return at;
}

// A cut may hold up a meeting by as much as it lasts, and what comes behind; on the whole that is
// less than one hundredth of the mission.
TEST(ActionCuts, ShortOnesLeaveNoVisibleMark) {
  constexpr double kLongestCut = 30;  // [s]
  const auto seeds = cases<std::uint64_t>(2, 50);
  constexpr double kVisible = 0.01;  // of what the mission lasts
  double sum = 0, goals = 0, duration = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    scenario::Scenario scenario = scenario_at("action/patrol", with(seed));
    const auto cut = achieved(play(scenario));
    scenario.radio.cuts.clear();
    const auto whole = achieved(play(scenario));
    ASSERT_EQ(cut.size(), whole.size());
    double end = 0;
    for (const auto& [goal, at] : whole) {
      const double later = cut.at(goal) - at;
      EXPECT_LE(later, kLongestCut) << goal << ", seed " << seed;
      sum += later;
      ++goals;
      end = std::max(end, at);
    }
    duration += end / static_cast<double>(seeds);
  }
  EXPECT_LE(sum / goals, kVisible * duration) << "[s], mean of all goals";
  RecordProperty("later", std::to_string(sum / goals));
}

}  // namespace
}  // namespace skein::testing
