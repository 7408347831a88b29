// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_setup/page_world.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace skein::ground_setup {
namespace {

using Json = nlohmann::json;

scenario::Scenario comets() {
  auto scenario =
      scenario::read_scenario(std::string(SKEIN_SOURCE_DIR) + "/scenarios/comets/confirmed.yaml");
  if (!scenario) ADD_FAILURE() << to_text(scenario.error());
  return scenario ? *scenario : scenario::Scenario();
}

TEST(PageWorld, SaysWhatAMetreHomeTakesOfWhatAUavHolds) {
  scenario::Scenario scenario = comets();
  world::VehicleModel& model = scenario.uavs.at(0).model;
  model.cruise_speed = 8;
  model.energy.capacity = 1e6;
  model.energy.cruise_power = 1000;
  model.energy.reserve = 0.25;

  const Json uav = Json::parse(page_world(scenario))["uavs"][0];

  EXPECT_DOUBLE_EQ(uav["energy"]["metre"].get<double>(), 1000.0 / 8 / 1e6);
  EXPECT_EQ(uav["energy"]["reserve"], 0.25);
}

TEST(PageWorld, IsOfModestSizeWhateverTheGround) {
  scenario::Scenario scenario = comets();
  scenario.world.terrain.west = scenario.world.terrain.south = -5000;
  scenario.world.terrain.east = scenario.world.terrain.north = 5000;
  scenario.world.terrain.cell = 20;

  const Json terrain = Json::parse(page_world(scenario))["terrain"];

  EXPECT_LE(terrain["columns"].get<int>(), 160);
  EXPECT_EQ(terrain["heights"].size(),
            terrain["columns"].get<std::size_t>() * terrain["rows"].get<std::size_t>());
}

TEST(PageWorld, NamesAreTextWhateverTheyAre) {
  scenario::Scenario scenario = comets();
  scenario.name = "\"}</script>\xff";

  const Json page = Json::parse(page_world(scenario), nullptr, false);

  ASSERT_FALSE(page.is_discarded());
  EXPECT_EQ(page["scenario"].get<std::string>().substr(0, 11), "\"}</script>");
}

}  // namespace
}  // namespace skein::ground_setup
