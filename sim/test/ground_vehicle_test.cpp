// SPDX-License-Identifier: Apache-2.0
// What keeps to the ground, through the simulator.
#include <gtest/gtest.h>

#include <algorithm>

#include "testing.hpp"

namespace skein::sim {
namespace {

using testing::a_config;
using testing::altitude;
using testing::Flight;
using testing::way;
using world::Vector2;
using world::Vector3;

SimulatorConfig a_robot(const world::Terrain& terrain) {
  SimulatorConfig config = a_config({});
  config.terrain = terrain;
  config.vehicles.push_back(testing::a_vehicle("marvin"));
  config.vehicles.back().model = testing::model_of("../../action/models/mana");
  return config;
}

TEST(GroundVehicle, DrivesThereOnTheGroundAndStands) {
  Flight flight(a_robot(testing::with_hill(100, 0, 5, 200)));

  flight.dispatch("marvin", 1, "goto", way({{100, 0, 77}, {200, 50, 0}}));
  double highest = 0;
  for (int i = 0; i < 90; ++i) {
    flight.run_for(1);
    const Vector3 at = flight.state("marvin").position;
    highest = std::max(highest, at.z());
    EXPECT_NEAR(at.z(), testing::with_hill(100, 0, 5, 200).elevation(at.x(), at.y()), 0.1);
    EXPECT_FALSE(flight.state("marvin").airborne);
  }
  ASSERT_TRUE(flight.run_to_end_of(1));

  EXPECT_EQ(flight.history(1), "running ended") << flight.reason(1);
  EXPECT_GT(highest, 4);
  EXPECT_LT((flight.state("marvin").position.head<2>() - Vector2(200, 50)).norm(), 3);
  EXPECT_LT(flight.state("marvin").energy, 1);
}

TEST(GroundVehicle, NeitherTakesOffNorLandsNorClimbsWhatIsTooSteep) {
  Flight flight(a_robot(testing::with_hill(100, 0, 60, 90)));

  flight.dispatch("marvin", 1, "takeoff", altitude(20));
  flight.dispatch("marvin", 2, "land");
  flight.dispatch("marvin", 3, "goto", way({{100, 0, 0}}));

  EXPECT_EQ(flight.reason(1), "it keeps to the ground");
  EXPECT_NE(flight.reason(2).find("it keeps to the ground"), std::string::npos);
  EXPECT_NE(flight.reason(3).find("too steep for it"), std::string::npos) << flight.reason(3);
}

TEST(GroundVehicle, StopsWhenItIsInterruptedAndLooksFromWhereItStands) {
  Flight flight(a_robot(testing::flat()));
  flight.dispatch("marvin", 1, "goto", way({{300, 0, 0}}));
  flight.run_for(20);

  flight.interrupt("marvin", 1);
  flight.run_for(5);
  const Vector3 stood = flight.state("marvin").position;
  flight.dispatch("marvin", 2, "perceive", testing::device("visible").add("duration", 20.0));
  flight.run_for(10);

  EXPECT_EQ(flight.history(1), "running aborted");
  EXPECT_EQ((flight.state("marvin").position - stood).norm(), 0);
  ASSERT_TRUE(flight.run_to_end_of(2));
  EXPECT_EQ(flight.history(2), "running ended");
}

}  // namespace
}  // namespace skein::sim
