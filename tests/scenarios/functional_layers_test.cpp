// SPDX-License-Identifier: Apache-2.0
// Missions whose vehicles are played by functional layers of their own: they go as they go when the
// simulator plays all vehicles.
#include <gtest/gtest.h>

#include "skein/laws/protocol.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

/// What the functional layer of a UAV did, in order: "3 goto ended at 81.2".
std::vector<std::string> deeds(const Mission& mission, const std::string& uav) {
  std::vector<std::string> deeds;
  for (const journal::Record& line : mission.find({{"kind", "functional"}, {"uav", uav}})) {
    deeds.push_back(std::to_string(static_cast<int>(line.number("task"))) + " " +
                    std::string(line.text("type")) + " " + std::string(line.text("state")) +
                    " at " + std::to_string(line.at().to_seconds()).substr(0, 6));
  }
  return deeds;
}

scenario::Scenario with_layers(scenario::Scenario scenario,
                               const std::map<std::string, std::string>& layers) {
  for (scenario::UavSpec& uav : scenario.uavs) {
    const auto own = layers.find(uav.name);
    if (own != layers.end()) uav.functional = own->second;
  }
  return scenario;
}

class OwnLayers : public ::testing::TestWithParam<std::map<std::string, std::string>> {};

TEST_P(OwnLayers, FlyTheCometsMissionAsTheSimulatorDoes) {
  for (const char* degree : {"1", "2", "3"}) {
    const scenario::Scenario whole = comets("confirmed", with(1, {degree}));

    const Mission alone = play(whole);
    const Mission shared = play(with_layers(whole, GetParam()));

    EXPECT_EQ(shared.end, End::kFinished);
    EXPECT_EQ(shared.failures(), "");
    EXPECT_EQ(laws::to_text(laws::broken_protocol(shared.records)), "");
    EXPECT_EQ(shared.untrue, "");
    for (const scenario::UavSpec& uav : whole.uavs) {
      EXPECT_EQ(deeds(shared, uav.name), deeds(alone, uav.name)) << uav.name << " at " << degree;
    }
    for (const auto& [uav, layer] : GetParam()) {
      EXPECT_EQ(shared.count({{"kind", "functional"}, {"uav", uav}, {"node", "sim"}}), 0U);
      EXPECT_GT(shared.count({{"kind", "functional"}, {"uav", uav}, {"node", layer}}), 0U);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    FunctionalLayers, OwnLayers,
    ::testing::Values(std::map<std::string, std::string>{{"heliv", "autopilot"}},
                      std::map<std::string, std::string>{{"marvin", "two"}, {"karma", "two"}},
                      std::map<std::string, std::string>{
                          {"marvin", "m"}, {"heliv", "h"}, {"karma", "k"}}),
    [](const auto& one) { return "of_" + std::to_string(one.param.size()); });

// The radio follows the vehicles wherever they are played, and faults meet those they are for.
TEST(FunctionalLayers, AMissionPlannedOnBoardGoesAsWithTheSimulator) {
  const scenario::Scenario whole = scenario_at("karma/detection");

  const Mission alone = play(whole);
  const Mission shared = play(with_layers(whole, {{"karma", "autopilot"}}));

  EXPECT_EQ(shared.failures(), "");
  EXPECT_EQ(shared.untrue, "");
  EXPECT_EQ(deeds(shared, "karma"), deeds(alone, "karma"));
}

TEST(FunctionalLayers, AFaultMeetsTheVehicleWhereItIsPlayed) {
  const auto faulty = [] {
    scenario::Scenario scenario = comets("confirmed", with(1));
    scenario.faults.breaks.push_back({MissionTime::seconds(100), "heliv", "infrared"});
    scenario.faults.breaks.push_back({MissionTime::seconds(120), "marvin", ""});
    return scenario;
  };

  const Mission alone = play(faulty());
  const Mission shared = play(with_layers(faulty(), {{"heliv", "autopilot"}}));

  EXPECT_EQ(shared.count({{"kind", "fault"}, {"node", "autopilot"}, {"target", "heliv"}}), 1U);
  EXPECT_EQ(shared.count({{"kind", "fault"}, {"node", "sim"}, {"target", "marvin"}}), 1U);
  EXPECT_EQ(shared.count({{"kind", "fault"}}), alone.count({{"kind", "fault"}}));
}

}  // namespace
}  // namespace skein::testing
