// SPDX-License-Identifier: Apache-2.0
// What a scenario says of the DDS that its daemons use.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/files.hpp"

namespace skein::scenario {
namespace {

using ::testing::AllOf;
using testing::errors_of;
using ::testing::HasSubstr;
using testing::planning_scenario_with;
using testing::read_valid;

std::string with_dds(const std::string& dds) {
  return planning_scenario_with("do: [{finish: true}]", "do: [{finish: true}]") + dds + "\n";
}

TEST(DdsOfAScenario, IsFastDdsWhereNothingIsSaid) {
  const Scenario scenario = read_valid(with_dds(""));

  EXPECT_EQ(scenario.dds_of("ground"), "fastdds");
}

TEST(DdsOfAScenario, IsOneForAllOrOneForEachNodeThatIsNamed) {
  const Scenario all = read_valid(with_dds("dds: cyclonedds"));
  const Scenario some = read_valid(with_dds("dds: {karma: cyclonedds, runner: cyclonedds}"));

  EXPECT_EQ(all.dds_of("karma"), "cyclonedds");
  EXPECT_EQ(some.dds_of("karma"), "cyclonedds");
  EXPECT_EQ(some.dds_of("runner"), "cyclonedds");
  EXPECT_EQ(some.dds_of("heliv"), "fastdds");
}

TEST(DdsOfAScenario, WrongWordsAndNodesAreNamedWithTheNearestRightOnes) {
  EXPECT_THAT(errors_of(with_dds("dds: cyclone")),
              HasSubstr("dds: unknown name 'cyclone'; expected whose DDS"));
  EXPECT_THAT(errors_of(with_dds("dds: {karm: fastdds, sim: opendds}")),
              AllOf(HasSubstr("no node 'karm'"), HasSubstr("'opendds'")));
}

}  // namespace
}  // namespace skein::scenario
