// SPDX-License-Identifier: Apache-2.0
// Missions of high-level tasks on board (spec 8.3 to 8.5, 8.10) and what may befall them, over many
// seeds: each draws other winds, speeds, delays, losses and sensor noise.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>

#include "skein/laws/protocol.hpp"
#include "test_cases.hpp"
#include "testing/deliberation_laws.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class Deliberation : public ::testing::TestWithParam<std::string> {};

TEST_P(Deliberation, MeetsEveryExpectationAndKeepsTheLawsWhateverTheSeed) {
  const auto seeds = cases<std::uint64_t>(2, 50);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Mission mission = play(scenario_at(GetParam(), with(seed)));

    EXPECT_EQ(mission.end, End::kFinished) << "seed " << seed;
    EXPECT_EQ(mission.failures(), "") << "seed " << seed;
    EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "") << "seed " << seed;
    EXPECT_EQ(mission.untrue, "") << "seed " << seed;
    EXPECT_EQ(laws::to_text(broken_deliberation_laws(mission.records)), "") << "seed " << seed;
  }
}

// Who tells whom what is another matter each time.
TEST(Consistency, OfOneMissionIsKeptByEachAlgorithm) {
  using temporal::Algorithm;
  const auto told = [](const Mission& mission, const std::string& to) {
    return mission.count({{"kind", "frontier"}, {"direction", "sent"}, {"to", to}});
  };
  for (const Algorithm one :
       {Algorithm::kDipM, Algorithm::kDipL, Algorithm::kDipG, Algorithm::kCip}) {
    scenario::Scenario scenario = scenario_at("meetings/late-partner", with(1));
    scenario.planning->consistency = one;

    const Mission mission = play(scenario);

    EXPECT_EQ(mission.end, End::kFinished) << to_text(one);
    EXPECT_EQ(mission.failures(), "") << to_text(one);
    // That one of its missions cannot be is what it is for; law `feasible` knows of no partners.
    for (const char* law : {" healed: ", " foretold: "})
      EXPECT_THAT(mission.untrue, Not(HasSubstr(law))) << to_text(one);
    EXPECT_GT(told(mission, "marvin"), 0U) << to_text(one);
    EXPECT_EQ(told(mission, "ground") > 0, one == Algorithm::kCip) << to_text(one);
  }
}

TEST_P(Deliberation, IsTheSameByteForByteForOneSeedAndAnotherForAnother) {
  const std::string once = play(scenario_at(GetParam(), with(1))).log();
  const std::string again = play(scenario_at(GetParam(), with(1))).log();
  const std::string other = play(scenario_at(GetParam(), with(2))).log();

  EXPECT_TRUE(once == again);
  EXPECT_FALSE(once == other);
}

std::string name_of(const ::testing::TestParamInfo<std::string>& one) {
  std::string name = one.param;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Virtual, Deliberation,
                         ::testing::Values("karma/detection", "heliv-marvin/monitoring",
                                           "iros2005/fire", "handover/radio", "handover/cut",
                                           "comets/mixed", "deadlines/after-a-goal",
                                           "deadlines/slack", "deadlines/in-parts",
                                           "deadlines/parts-planned", "jacksboro/fire"),
                         name_of);
INSTANTIATE_TEST_SUITE_P(
    Contingencies, Deliberation,
    ::testing::Values(
        "contingencies/slow-goto", "contingencies/takeshot-aborted",
        "contingencies/refused-for-ever", "contingencies/sensor-dead",
        "contingencies/no-fly-appears", "contingencies/energy-short",
        "contingencies/urgent-mission", "contingencies/later-during-perception",
        "contingencies/mission-while-waiting-on-ground", "contingencies/true-when-its-turn-comes",
        "contingencies/partner-never-comes", "contingencies/orders-never-come",
        "contingencies/air-closes-around", "contingencies/air-closes-later",
        "contingencies/air-closes-on-perception", "contingencies/air-closes-on-circle",
        "contingencies/air-closes-where-it-was-stopped", "contingencies/air-closes-while-holding",
        "contingencies/steep-home", "contingencies/steep-home-out-of-contact",
        "contingencies/closed-for-a-time", "contingencies/rung-re-refine",
        "contingencies/rung-drop", "contingencies/rung-shift", "contingencies/rung-replan",
        "contingencies/rung-absorb", "contingencies/rung-fail", "contingencies/progress-kept",
        "contingencies/mapping-goes-on", "contingencies/partner-gives-up",
        "contingencies/landing-given-up", "contingencies/takeoff-without-contact",
        "contingencies/joint-task-called-off", "contingencies/joint-task-never-loaded",
        "handover/held-tasks", "handover/synchronised", "handover/cancelled-at-ground",
        "handover/held-by-hand", "handover/narrow-radio", "deadlines/orders-after-a-goal",
        "contingencies/room-while-waiting-for-orders"),
    name_of);

// What each decision of that operator came to.
std::vector<std::string> outcomes_of(const Mission& mission, const std::string& operator_name) {
  std::vector<std::string> outcomes;
  for (const journal::Record& record : mission.records) {
    if (record.kind() == "decision" && record.text("operator") == operator_name)
      outcomes.emplace_back(record.text("outcome"));
  }
  return outcomes;
}

TEST(Slack, IsTakenFromBothLooksAtFirstAndFromTheSecondWhenTheWayToItTakesLonger) {
  const Mission mission = play(scenario_at("deadlines/slack", with(1)));

  EXPECT_THAT(
      outcomes_of(mission, "1 insert: last"),
      ElementsAre(AllOf(HasSubstr("mended by slack: goal 701 to "), HasSubstr("goal 702 to "))));
  EXPECT_THAT(outcomes_of(mission, "6 repair: re-refine"),
              Contains(HasSubstr("mended by slack: goal 702 to ")));
  EXPECT_THAT(outcomes_of(mission, "1 insert"),
              Contains(HasSubstr("it could be planned with goal 710 end-before ")));
}

}  // namespace
}  // namespace skein::testing
