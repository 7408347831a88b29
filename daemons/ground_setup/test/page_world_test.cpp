// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_setup/page_world.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include "testing/comets.hpp"

namespace skein::ground_setup {
namespace {

using Json = nlohmann::json;

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

// What scenarios/models/interaction/monitoring-with-relay.yaml and scms.yaml say, read by hand.
TEST(PageWorld, SaysWhichConstraintsARoleHasInWhichBlocks) {
  const auto scenario =
      scenario::read_scenario(std::string(SKEIN_SOURCE_DIR) + "/scenarios/mref/nominal.yaml");
  ASSERT_TRUE(scenario) << to_text(scenario.error());

  const Json pair = Json::parse(page_world(*scenario))["joint"]["monitoring-with-relay"]["pair"];

  EXPECT_EQ(pair["arguments"], Json::array({"p0", "p1", "p2", "p3"}))
      << "the list of UAVs is left out";
  EXPECT_EQ(pair["roles"], Json::array({"perceive", "relay"}));
  const auto of = [&](const char* scm, const char* role) {
    for (const Json& one : pair["constraints"])
      if (one["scm"] == scm && one["role"] == role) return one;
    return Json();
  };
  EXPECT_EQ(of("mcs1", "relay")["blocks"], Json::array({"b20"}));
  EXPECT_EQ(of("mcs1", "relay")["all"][0]["of"], Json::array({"R*"}));
  EXPECT_EQ(of("mcs3", "perceive"), Json()) << "only the relay has it";
  EXPECT_EQ(
      of("mcs3", "relay")["all"],
      Json::parse(R"([{"quantity": "distance", "of": ["perceive"], "relation": "<", "than": 100},
                            {"quantity": "distance", "of": ["p2"], "relation": "<", "than": 100}])"));
  EXPECT_EQ(of("mcs2", "perceive")["all"][2],
            Json::parse(R"({"quantity": "azimuth", "of": ["p0", "p1"], "relation": "=", "than": 0,
                            "tolerance": 0.2})"));
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
