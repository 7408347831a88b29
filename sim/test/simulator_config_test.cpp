// SPDX-License-Identifier: Apache-2.0
#include "skein/sim/simulator_config.hpp"

#include <gmock/gmock.h>

#include "testing.hpp"

namespace skein::sim {
namespace {

using testing::a_config;
using testing::a_vehicle;
using testing::an_object;
using testing::at;

TEST(SimulatorConfig, TheBuildersOfTheseTestsMakeASoundOne) {
  EXPECT_TRUE(problems_of(a_config({"marvin", "heliv", "karma"})).empty());
}

TEST(SimulatorConfig, EachWrongFigureIsNamed) {
  struct Case {
    const char* expected;
    void (*spoil)(SimulatorConfig&);
  };
  const std::vector<Case> cases = {
      {"a vehicle has no name", [](SimulatorConfig& c) { c.vehicles[0].name = ""; }},
      {"vehicle 'ground': the name is taken",
       [](SimulatorConfig& c) { c.vehicles[0].name = "ground"; }},
      {"vehicle 'marvin' starts outside the terrain",
       [](SimulatorConfig& c) {
         c.vehicles[0].start = {9000, 0};
       }},
      {"vehicle 'marvin': energy at the start is not between 0 and 1",
       [](SimulatorConfig& c) { c.vehicles[0].energy = 1.2; }},
      {"vehicle 'marvin': its model 'marvin' has figures that must be greater than 0",
       [](SimulatorConfig& c) { c.vehicles[0].model.acceleration = 0; }},
      {"object 'fire' is outside the terrain",
       [](SimulatorConfig& c) { c.objects = {an_object("fire", 9000, 0)}; }},
      {"object 'fire': the name is taken",
       [](SimulatorConfig& c) {
         c.objects = {an_object("fire", 0, 0), an_object("fire", 1, 0)};
       }},
      {"object 'fire': radius, height and speed must not be negative",
       [](SimulatorConfig& c) {
         c.objects = {an_object("fire", 0, 0)};
         c.objects[0].radius = -1;
       }},
      {"radio: the range must be finite and greater than 0",
       [](SimulatorConfig& c) { c.radio.range = 0; }},
      {"radio: the loss must be at least 0 and less than 1",
       [](SimulatorConfig& c) { c.radio.loss = 1; }},
      {"radio cut: unknown node 'marvn'",
       [](SimulatorConfig& c) {
         c.cuts = {{"marvn", "ground", at(0), at(1)}};
       }},
      {"radio cut: 'marvin' and itself",
       [](SimulatorConfig& c) {
         c.cuts = {{"marvin", "marvin", at(0), at(1)}};
       }},
      {"radio cut: it ends before it begins",
       [](SimulatorConfig& c) {
         c.cuts = {{"marvin", "ground", at(2), at(1)}};
       }},
      {"periods must be greater than 0", [](SimulatorConfig& c) { c.step = Duration(); }},
      {"wind: speed and gusts must be finite and not negative",
       [](SimulatorConfig& c) { c.wind.speed = -1; }},
      {"the position of the ground station is no position",
       [](SimulatorConfig& c) { c.ground_station.x() = std::nan(""); }},
  };
  for (const Case& c : cases) {
    SimulatorConfig config = a_config();

    c.spoil(config);

    EXPECT_THAT(problems_of(config), ::testing::ElementsAre(c.expected));
  }
}

TEST(SimulatorConfig, ALinkBudgetNeedsNoRange) {
  SimulatorConfig config = a_config();
  config.radio.range = 0;
  config.radio.budget = world::LinkBudget{20, -90, 40, 2};

  EXPECT_TRUE(problems_of(config).empty());
  config.radio.budget->path_loss_exponent = 0;
  EXPECT_THAT(problems_of(config), ::testing::SizeIs(1));
}

TEST(SimulatorConfig, AllProblemsAreGivenAtOnce) {
  SimulatorConfig config = a_config();
  config.vehicles.push_back(a_vehicle("marvin", 5000));
  config.radio.range = -1;

  EXPECT_EQ(problems_of(config).size(), 3u);
}

}  // namespace
}  // namespace skein::sim
