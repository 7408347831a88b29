// SPDX-License-Identifier: Apache-2.0
#include "interaction/role_air.hpp"

#include <gtest/gtest.h>

namespace skein::decision_node {
namespace {

using world::Vector3;

/// 100 m by 100 m, from 200 m east on.
world::Volume smoke(double from, double until) {
  return {"smoke",
          {{200, -50}, {300, -50}, {300, 50}, {200, 50}},
          0,
          100,
          {MissionTime::seconds(from), MissionTime::seconds(until)}};
}

const world::Volume* met(const Vector3& at, const std::vector<double>& waypoints,
                         const std::vector<world::Volume>& volumes) {
  world::VehicleState state;
  state.position = at;
  world::VehicleModel model;
  model.cruise_speed = 10;
  return closed_ahead({{"waypoints", "", waypoints}}, {0, 0, 40}, state, model, volumes,
                      MissionTime::seconds(100));
}

TEST(ClosedAhead, IsTheVolumeThatTheRestOfTheWayComesInto) {
  const std::vector<world::Volume> volumes{smoke(90, 500)};
  ASSERT_NE(met({0, 0, 40}, {250, 0, 40}, volumes), nullptr);
  EXPECT_EQ(met({0, 0, 40}, {250, 0, 40}, volumes)->name, "smoke");
  EXPECT_EQ(met({0, 0, 40}, {150, 0, 40}, volumes), nullptr);
  EXPECT_EQ(met({0, 0, 40}, {250, 0, 140, 0, 0, 140}, {smoke(90, 500)}), nullptr);
}

TEST(ClosedAhead, IsNothingWhereItHasFlownBy) {
  EXPECT_EQ(met({350, 200, 40}, {250, 0, 40, 350, 0, 40, 350, 400, 40}, {smoke(90, 500)}), nullptr);
}

// Straight to the second way-point it would come into it.
TEST(ClosedAhead, IsNothingBesideAWayAround) {
  const std::vector<double> around{0, 100, 40, 350, 100, 40, 350, 0, 40};
  for (const Vector3& at : {Vector3(0, 0, 40), Vector3(10, 50, 40), Vector3(320, 98, 40)})
    EXPECT_EQ(met(at, around, {smoke(90, 500)}), nullptr) << at.transpose();
}

TEST(ClosedAhead, CountsWhatIsClosedNowOrSoon) {
  EXPECT_NE(met({0, 0, 40}, {250, 0, 40}, {smoke(120, 500)}), nullptr);
  EXPECT_EQ(met({0, 0, 40}, {250, 0, 40}, {smoke(140, 500)}), nullptr);
  EXPECT_EQ(met({0, 0, 40}, {250, 0, 40}, {smoke(50, 90)}), nullptr);
}

// Found by hand (area-sharing/air-closes): lanes to be flown ten minutes later.
TEST(ClosedAhead, IsNothingThatIsOpenAgainByTheTime) {
  const std::vector<double> long_way{0, 400, 40, -400, 400, 40, -400, 0, 40, 250, 0, 40};
  EXPECT_EQ(met({0, 0, 40}, long_way, {smoke(90, 200)}), nullptr);
  EXPECT_NE(met({0, 0, 40}, long_way, {smoke(90, 500)}), nullptr);
}

TEST(ClosedAhead, LetsLeaveWhoIsInIt) {
  EXPECT_EQ(met({250, 0, 40}, {400, 0, 40}, {smoke(90, 500)}), nullptr);
}

}  // namespace
}  // namespace skein::decision_node
