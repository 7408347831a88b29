// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario_setup/overrides.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace skein::scenario_setup {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

scenario::Scenario a_scenario() {
  scenario::Scenario scenario;
  scenario.duration_limit = MissionTime::seconds(3600);
  scenario.rate = 20;
  scenario.seed = 1;
  for (const char* name : {"marvin", "heliv", "karma"}) {
    scenario.uavs.emplace_back().name = name;
  }
  return scenario;
}

std::vector<int> degrees_of(const scenario::Scenario& scenario) {
  std::vector<int> degrees;
  for (const auto& uav : scenario.uavs) degrees.push_back(uav.degree);
  return degrees;
}

Overrides with_degrees(std::vector<std::string> degrees) {
  Overrides overrides;
  overrides.degrees = std::move(degrees);
  return overrides;
}

TEST(Overrides, NoneChangesNothing) {
  scenario::Scenario scenario = a_scenario();

  EXPECT_TRUE(apply({}, scenario).empty());

  EXPECT_EQ(scenario.rate, 20);
  EXPECT_EQ(scenario.seed, 1U);
  EXPECT_THAT(degrees_of(scenario), ElementsAre(3, 3, 3));
}

TEST(Overrides, RateAndSeedReplaceTheScenarios) {
  scenario::Scenario scenario = a_scenario();
  Overrides overrides;
  overrides.rate = 2.5;
  overrides.seed = 99;

  EXPECT_TRUE(apply(overrides, scenario).empty());

  EXPECT_EQ(scenario.rate, 2.5);
  EXPECT_EQ(scenario.seed, 99U);
}

struct DegreeCase {
  std::string name;
  std::vector<std::string> given;
  std::vector<int> degrees;
};
class Degrees : public ::testing::TestWithParam<DegreeCase> {};

TEST_P(Degrees, AreSetInOrderSoThatLaterOnesWin) {
  scenario::Scenario scenario = a_scenario();

  EXPECT_TRUE(apply(with_degrees(GetParam().given), scenario).empty());

  EXPECT_EQ(degrees_of(scenario), GetParam().degrees);
}

INSTANTIATE_TEST_SUITE_P(Overrides, Degrees,
                         ::testing::Values(DegreeCase{"all", {"2"}, {2, 2, 2}},
                                           DegreeCase{"one", {"heliv=1"}, {3, 1, 3}},
                                           DegreeCase{"four", {"heliv=4"}, {3, 4, 3}},
                                           DegreeCase{"all_but_one", {"1", "karma=3"}, {1, 1, 3}},
                                           DegreeCase{"one_then_all", {"karma=2", "1"}, {1, 1, 1}},
                                           DegreeCase{
                                               "twice", {"marvin=1", "marvin=2"}, {2, 3, 3}}),
                         [](const auto& one) { return one.param.name; });

class BadDegrees : public ::testing::TestWithParam<std::string> {};

TEST_P(BadDegrees, AreRefusedAndChangeNothing) {
  scenario::Scenario scenario = a_scenario();

  const Diagnostics diagnostics = apply(with_degrees({GetParam()}), scenario);

  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_THAT(to_text(diagnostics), HasSubstr("--degree"));
  EXPECT_THAT(degrees_of(scenario), ElementsAre(3, 3, 3));
}

INSTANTIATE_TEST_SUITE_P(Overrides, BadDegrees,
                         ::testing::Values("0", "6", "", "three", "22", "-1", "marvin=", "marvin=9",
                                           "marvin=1=2", "1.0", " 1", "=", "=9"));

TEST(Overrides, Degree5IsOfTeamsOnlyAndEachUavThatIsInNoneIsNamed) {
  scenario::Scenario scenario = a_scenario();

  const Diagnostics diagnostics = apply(with_degrees({"5"}), scenario);

  ASSERT_EQ(diagnostics.size(), 3U);
  EXPECT_THAT(to_text(diagnostics), HasSubstr("marvin is in no team"));
  EXPECT_THAT(degrees_of(scenario), ElementsAre(3, 3, 3));
}

TEST(Overrides, AnEmptyNameBeforeTheDegreeIsNotEverybody) {
  scenario::Scenario scenario = a_scenario();

  EXPECT_FALSE(apply(with_degrees({"=1"}), scenario).empty());

  EXPECT_THAT(degrees_of(scenario), ElementsAre(3, 3, 3));
}

TEST(Overrides, AnUnknownUavIsRefusedWithTheNearestName) {
  scenario::Scenario scenario = a_scenario();

  const Diagnostics diagnostics = apply(with_degrees({"marvn=1"}), scenario);

  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].nearest, "marvin");
  EXPECT_THAT(diagnostics.all()[0].message, HasSubstr("marvn"));
}

class BadRates : public ::testing::TestWithParam<double> {};

TEST_P(BadRates, AreRefused) {
  scenario::Scenario scenario = a_scenario();
  Overrides overrides;
  overrides.rate = GetParam();

  EXPECT_THAT(to_text(apply(overrides, scenario)), HasSubstr("--rate"));
}

INSTANTIATE_TEST_SUITE_P(Overrides, BadRates,
                         ::testing::Values(0.0, -1.0, 0.009, 1001.0,
                                           std::numeric_limits<double>::infinity(),
                                           std::numeric_limits<double>::quiet_NaN()));

TEST(Overrides, EveryErrorIsToldAtOnce) {
  scenario::Scenario scenario = a_scenario();
  Overrides overrides = with_degrees({"7", "nobody=1", "2"});
  overrides.rate = -3;

  EXPECT_EQ(apply(overrides, scenario).size(), 3U);
}

TEST(Overrides, RandomFaultsAreDrawnWithTheSeedInForce) {
  scenario::Scenario first = a_scenario();
  first.faults.random = {20, 20, 10, 5};
  scenario::Scenario again = first;
  scenario::Scenario other = first;
  Overrides seven;
  seven.seed = 7;
  Overrides eight;
  eight.seed = 8;

  EXPECT_TRUE(apply(seven, first).empty());
  EXPECT_TRUE(apply(seven, again).empty());
  EXPECT_TRUE(apply(eight, other).empty());

  ASSERT_FALSE(first.radio.cuts.empty());
  ASSERT_FALSE(other.radio.cuts.empty());
  EXPECT_EQ(first.radio.cuts.size(), again.radio.cuts.size());
  EXPECT_EQ(first.radio.cuts[0].from, again.radio.cuts[0].from);
  EXPECT_NE(first.radio.cuts[0].from, other.radio.cuts[0].from);
}

TEST(Overrides, VariationsAreDrawnWithTheSeedInForce) {
  scenario::Scenario first = a_scenario();
  first.variations.speed_factor = {0.9, 1.1};
  scenario::Scenario again = first, other = first;
  Overrides seven, eight;
  seven.seed = 7;
  eight.seed = 8;

  EXPECT_TRUE(apply(seven, first).empty());
  EXPECT_TRUE(apply(seven, again).empty());
  EXPECT_TRUE(apply(eight, other).empty());

  EXPECT_EQ(first.uavs[0].speed_factor, again.uavs[0].speed_factor);
  EXPECT_NE(first.uavs[0].speed_factor, other.uavs[0].speed_factor);
  EXPECT_NE(first.uavs[0].speed_factor, first.uavs[1].speed_factor);
}

TEST(Overrides, AsOptionsTheyMeanTheSameToAnotherProgram) {
  Overrides overrides = with_degrees({"2", "marvin=1"});
  overrides.rate = 0.1;
  overrides.seed = 18'446'744'073'709'551'615U;

  const std::vector<std::string> options = overrides.as_options();

  ASSERT_EQ(options.size(), 8U);
  EXPECT_EQ(options[0], "--rate");
  EXPECT_EQ(std::stod(options[1]), 0.1);
  EXPECT_EQ(options[3], "18446744073709551615");
  EXPECT_THAT(std::vector<std::string>(options.begin() + 4, options.end()),
              ElementsAre("--degree", "2", "--degree", "marvin=1"));
}

TEST(Overrides, NoneAreNoOptions) { EXPECT_THAT(Overrides{}.as_options(), IsEmpty()); }

}  // namespace
}  // namespace skein::scenario_setup
