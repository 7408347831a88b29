// SPDX-License-Identifier: Apache-2.0
#include "skein/mission_lab/rough_ground.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <set>

#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {
namespace {

using ::testing::ElementsAre;

Mission with_places(const std::vector<std::string>& places) {
  Mission mission;
  mission.seed = 1;
  mission.team = {{"marvin", "marvin", "start: [0, 0]", 40, 100}};
  mission.places = places;
  return mission;
}

YAML::Node hills_of(const Mission& mission) { return YAML::Load("[" + mission.hills + "]"); }

double distance(const YAML::Node& hill, double x, double y) {
  return std::hypot(hill["at"][0].as<double>() - x, hill["at"][1].as<double>() - y);
}

TEST(RoughGround, IsLevelWhereVehiclesStartAndLand) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Mission mission = with_places({"H1: [400, 300, 0]"});
    mission.seed = seed;
    roughen(mission);
    for (const auto& hill : hills_of(mission)) {
      EXPECT_GT(distance(hill, 0, 0), hill["radius"].as<double>());
      EXPECT_GT(distance(hill, 400, 300), hill["radius"].as<double>());
    }
  }
}

TEST(RoughGround, IsSteepAndAnotherForEachSeed) {
  std::set<std::string> all;
  double steepest = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Mission mission = generate_crossing(seed, kClean);
    roughen(mission);
    all.insert(mission.hills);
    for (const auto& hill : hills_of(mission))
      steepest = std::max(steepest, hill["height"].as<double>() / hill["radius"].as<double>());
  }
  EXPECT_EQ(all.size(), 50U);
  EXPECT_GT(steepest, 0.7);
}

TEST(RoughGround, CarriesThePlacesThatWereOnThePlain) {
  Mission mission = with_places({"P1: [300, 200, 0]", "P2: [500, 100]"});
  roughen(mission);
  EXPECT_THAT(mission.places, ElementsAre("P1: [300, 200]", "P2: [500, 100]"));
}

TEST(RoughGround, LeavesPlacesInTheAirAsHighAboveIt) {
  Mission mission = with_places({"A1: [0, 0, 80]"});
  roughen(mission);
  EXPECT_THAT(mission.places, ElementsAre("A1: [0, 0, 80]"));

  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Mission over = with_places({"A1: [520, 310, 80]"});
    over.seed = seed;
    roughen(over);
    double ground = 0;
    for (const auto& hill : hills_of(over)) {
      const double away = distance(hill, 520, 310) / hill["radius"].as<double>();
      if (away < 1) ground += hill["height"].as<double>() * std::pow(std::cos(away * M_PI_2), 2);
    }
    EXPECT_EQ(over.places[0], "A1: [520, 310, " + std::to_string(std::lround(80 + ground)) + "]");
  }
}

}  // namespace
}  // namespace skein::mission_lab
