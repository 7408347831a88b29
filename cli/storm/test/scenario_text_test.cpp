// SPDX-License-Identifier: Apache-2.0
// Scenario files are changed as text, and stay scenarios.
#include "skein/storm_tool/scenario_text.hpp"

#include "skein/scenario_text/scenario_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <fstream>

#include "skein/assembly/assembly.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::storm_tool {
namespace {

using ::testing::HasSubstr;

const std::string kFolder = SKEIN_SOURCE_DIR "/scenarios/comets";

std::string comets() {
  std::ifstream in(kFolder + "/confirmed.yaml");
  return {std::istreambuf_iterator<char>(in), {}};
}

scenario::Scenario read(const std::string& yaml, const std::string& folder = kFolder) {
  auto scenario = scenario::read_scenario_text(yaml, folder + "/drawn.yaml");
  EXPECT_TRUE(scenario.has_value()) << to_text(scenario.error());
  return scenario ? std::move(*scenario) : scenario::Scenario();
}

TEST(WithTroubles, TheyComeBesideWhatTheScenarioHas) {
  mission_lab::Troubles troubles;
  troubles.faults = {"{at: 100, kill: sim, restart_after: 5}", "{at: 90, engine: karma}"};
  troubles.cuts = {"{between: [marvin, ground], from: 10, until: 40}"};
  troubles.loss = 0.25;
  const scenario::Scenario before = read(comets());

  const scenario::Scenario after = read(with_troubles(comets(), 77, troubles).value());

  EXPECT_EQ(after.seed, 77U);
  EXPECT_EQ(after.faults.kills.size(), before.faults.kills.size() + 1);
  EXPECT_EQ(after.faults.breaks.size(), before.faults.breaks.size() + 1);
  EXPECT_EQ(after.radio.cuts.size(), before.radio.cuts.size() + 1);
  EXPECT_DOUBLE_EQ(after.radio.model.loss, 0.25);
  EXPECT_EQ(after.uavs.size(), before.uavs.size());
  EXPECT_EQ(after.expectations.size(), before.expectations.size());
}

TEST(WithTroubles, SlowComputersTakeLongerToPlan) {
  mission_lab::Troubles troubles;
  troubles.planning_takes = 2.5;

  const YAML::Node after =
      YAML::Load(with_troubles("planning: {domain: d.lisp}", 1, troubles).value());

  EXPECT_EQ(after["planning"]["domain"].as<std::string>(), "d.lisp");
  EXPECT_EQ(after["planning"]["takes"].as<std::vector<double>>(), (std::vector<double>{0.05, 2.5}));
}

TEST(WithTroubles, SaysWhatIsNoDocument) {
  EXPECT_FALSE(with_troubles("[1, 2]", 1, {}).has_value());
  EXPECT_FALSE(with_troubles("a: [", 1, {}).has_value());
}

TEST(Smaller, HasOnePartLessEachAndEveryPartOnce) {
  const std::vector<std::string> all = smaller(comets());
  const std::string whole = scenario_text::moved(comets(), kFolder, kFolder);
  std::size_t scenarios = 0;
  for (const std::string& less : all) {
    EXPECT_LT(less.size(), whole.size());
    scenarios += scenario::read_scenario_text(less, kFolder + "/drawn.yaml").has_value() ? 1 : 0;
  }

  EXPECT_GT(all.size(), 40U);
  EXPECT_GT(scenarios, all.size() / 4);
}

TEST(Smaller, LeavesOutFaultsFirst) {
  const std::string text = "faults: [{at: 1, kill: sim}]\nuavs: {a: {model: m}, b: {model: n}}\n";

  const std::vector<std::string> all = smaller(text);

  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].find("kill"), std::string::npos);
  EXPECT_THAT(all[1], HasSubstr("kill"));
}

}  // namespace
}  // namespace skein::storm_tool
