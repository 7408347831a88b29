// SPDX-License-Identifier: Apache-2.0
// Which measures a scenario has, by name.
#include "skein/scenario/measures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::scenario {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using Quantity = ExpectMeasure::Quantity;

std::vector<std::string> names_of(const std::vector<NamedMeasure>& measures) {
  std::vector<std::string> names;
  for (const NamedMeasure& one : measures) names.push_back(one.name);
  return names;
}

Expectation expects(Quantity quantity, std::vector<std::string> uavs) {
  ExpectMeasure measure;
  measure.quantity = quantity;
  measure.uavs = std::move(uavs);
  return {"it", measure};
}

TEST(MeasuresOf, AnyScenarioAreThoseOfAnyRun) {
  EXPECT_THAT(names_of(measures_of(Scenario())), ElementsAre("mission-duration", "distance-flown",
                                                             "energy-left", "minimum-separation"));
}

TEST(MeasuresOf, AScenarioWithClosedAirHasTheTimeInIt) {
  Scenario scenario;
  scenario.world.volumes.emplace_back().name = "tower";

  const auto all = measures_of(scenario);

  EXPECT_EQ(all.back().name, "time-in-volume");
  EXPECT_EQ(all.back().what.air.size(), 1U);
}

TEST(MeasuresOf, SingleUavsComeOnceAndByTheirNames) {
  Scenario scenario;
  scenario.expectations = {expects(Quantity::kMinimumSeparation, {"marvin", "heliv"}),
                           expects(Quantity::kEnergyLeft, {"karma"}),
                           expects(Quantity::kEnergyLeft, {"karma"}),
                           expects(Quantity::kEnergyLeft, {})};
  std::vector<std::string> expected = names_of(measures_of_any_run());
  expected.insert(expected.end(), {"minimum-separation marvin heliv", "energy-left karma"});

  EXPECT_THAT(names_of(measures_of(scenario)), ElementsAreArray(expected));
}

TEST(MeasuresOf, AScenarioHaveUnits) {
  EXPECT_EQ(unit_of(Quantity::kDistanceFlown), "m");
  EXPECT_EQ(unit_of(Quantity::kMissionDuration), "s");
  EXPECT_EQ(unit_of(Quantity::kEnergyLeft), "");
}

TEST(MeasuresOf, SingleUavsHaveTheUnitOfTheirQuantity) {
  EXPECT_EQ(unit_of("minimum-separation marvin heliv"), "m");
  EXPECT_EQ(unit_of("mission-duration"), "s");
  EXPECT_EQ(unit_of("energy-left karma"), "");
  EXPECT_EQ(unit_of("something else"), "");
}

}  // namespace
}  // namespace skein::scenario
