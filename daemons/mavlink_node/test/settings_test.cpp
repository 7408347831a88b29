// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink_node/settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::mavlink_node {
namespace {

using ::testing::HasSubstr;

/// Three UAVs: two copters, and one that cannot hover.
scenario::Scenario a_scenario() {
  scenario::Scenario scenario;
  scenario.world.terrain.west = scenario.world.terrain.south = -100;
  scenario.world.terrain.east = scenario.world.terrain.north = 100;
  for (const char* name : {"marvin", "heliv", "karma"}) {
    scenario::UavSpec uav;
    uav.name = name;
    uav.model.hovers = uav.name != "karma";
    scenario.uavs.push_back(uav);
  }
  return scenario;
}

std::string why_not(const Settings& settings, const std::string& uav = "marvin") {
  const auto config = bridge_config_of(a_scenario(), uav, settings);
  return config ? "" : config.error().why;
}

TEST(Settings, AreReadAsTheyAreMeant) {
  Settings settings;
  settings.dialect = "px4";
  settings.system_id = "7";
  settings.camera = "100";
  const auto config = bridge_config_of(a_scenario(), "marvin", settings);

  ASSERT_TRUE(config.has_value());
  EXPECT_EQ(config->dialect, autopilot::Dialect::kPx4);
  EXPECT_EQ(config->system, 7);
  EXPECT_EQ(config->camera, 100);
  EXPECT_EQ(config->own, (mavlink::Address{245, 191}));
}

TEST(Settings, ByDefaultTheAutopilotSaysWhatItIs) {
  const auto config = bridge_config_of(a_scenario(), "marvin", {});

  ASSERT_TRUE(config.has_value());
  EXPECT_EQ(config->dialect, std::nullopt);
  EXPECT_EQ(config->system, std::nullopt);
}

TEST(Settings, EveryMistakeIsSaidAtOnce) {
  Settings settings;
  settings.dialect = "betaflight";
  settings.system_id = "0";
  settings.own_id = "x";
  const std::string why = why_not(settings, "karma");

  for (const char* one :
       {"cannot hover", "--dialect 'betaflight'", "--system-id '0'", "--own-id 'x'"})
    EXPECT_THAT(why, HasSubstr(one));
}

TEST(Settings, ALayerIsOfOneVehicle) {
  scenario::Scenario scenario = a_scenario();
  EXPECT_THAT(layer_of(scenario, "marvn").error().why, HasSubstr("did you mean 'marvin'?"));
  EXPECT_THAT(layer_of(scenario, "marvin").error().why, HasSubstr("played by the simulator"));
  scenario.uavs[0].functional = "autopilot";
  EXPECT_EQ(layer_of(scenario, "marvin").value(), "autopilot");
  scenario.uavs[1].functional = "autopilot";
  EXPECT_THAT(layer_of(scenario, "marvin").error().why, HasSubstr("'marvin' and 'heliv'"));
}

}  // namespace
}  // namespace skein::mavlink_node
