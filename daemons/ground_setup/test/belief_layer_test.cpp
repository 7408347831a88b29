// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_setup/belief_layer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "skein/ground_setup/page_world.hpp"
#include "testing/comets.hpp"

namespace skein::ground_setup {
namespace {

using Json = nlohmann::json;

// Straight down from 60 m over the middle of the terrain.
wire::PerceptionReport look_of(const std::string& uav, const Json& ground) {
  wire::PerceptionReport look;
  look.uav = uav;
  look.device = "fire-sensor";
  look.viewpoint = {(ground["west"].get<float>() + ground["east"].get<float>()) / 2,
                    (ground["south"].get<float>() + ground["north"].get<float>()) / 2, 200};
  look.view_direction = {0, 0, -1};
  look.range = 400;
  look.aperture = 0.4F;
  return look;
}

TEST(BeliefLayer, TellsTheRowsOfThePagesGridThatWereLookedAt) {
  const scenario::Scenario scenario = comets();
  const Json ground = Json::parse(page_world(scenario))["terrain"];
  BeliefLayer layer(scenario);

  const auto news = layer.see(look_of(scenario.uavs.at(0).name, ground));

  ASSERT_FALSE(news.empty());
  for (const auto& [key, json] : news) {
    const Json row = Json::parse(json)["belief"];
    const auto cells = row["cells"].get<std::string>();
    EXPECT_EQ(key, "belief " + std::to_string(row["row"].get<int>()));
    EXPECT_EQ(cells.size(), ground["columns"].get<std::size_t>());
    EXPECT_TRUE(std::all_of(cells.begin(), cells.end(),
                            [](char one) { return one == '.' || (one >= '0' && one < '4'); }))
        << "nothing was seen, so nothing is above the prior: " << cells;
    EXPECT_EQ(cells.front(), '.') << "the border was not looked at";
  }
  const Json middle = Json::parse(news[news.size() / 2].second)["belief"];
  EXPECT_NEAR(middle["row"].get<double>(), ground["rows"].get<double>() / 2, 2);
}

TEST(BeliefLayer, TakesNothingFromStrangersAndNothingThatIsNoLook) {
  const scenario::Scenario scenario = comets();
  const Json ground = Json::parse(page_world(scenario))["terrain"];
  BeliefLayer layer(scenario);

  EXPECT_TRUE(layer.see(look_of("a stranger", ground)).empty());
  EXPECT_TRUE(layer.see(wire::Telemetry()).empty());
}

}  // namespace
}  // namespace skein::ground_setup
