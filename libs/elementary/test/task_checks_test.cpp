// SPDX-License-Identifier: Apache-2.0
// Requests that a vehicle can fly, and the reasons for which it refuses others.
#include "skein/elementary/task_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "level_world.hpp"

namespace skein::elementary {
namespace {

using functional::Parameters;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A helicopter at 30 m over level ground that reaches 500 m either way.
class CheckedTask : public ::testing::Test {
 protected:
  CheckedTask() {
    model.cruise_speed = 5;
    model.max_speed = 10;
    model.climb_rate = model.descent_rate = 2;
    model.ceiling = 100;
    model.energy.capacity = 1e6;
    model.sensors.emplace_back().device = "visible";
    state.position = {0, 0, 30};
    state.airborne = true;
  }
  Result<ElementaryTask, Failure> task(const std::string& type,
                                       const Parameters& parameters) const {
    return checked_task(type, parameters, {model, world.terrain, state, engine_works});
  }
  /// Empty: it can do it.
  std::string refusal(const std::string& type, const Parameters& parameters = {}) const {
    const auto checked = task(type, parameters);
    return checked ? "" : checked.error().why;
  }

  world::World world = skein::testing::level_world(500);
  world::VehicleModel model;
  world::VehicleState state;
  bool engine_works = true;
};

TEST_F(CheckedTask, TakesItsHeightAboveTheGround) {
  state.airborne = false;
  const auto checked = task("takeoff", Parameters{}.add("altitude", 40));
  ASSERT_TRUE(checked) << checked.error().why;
  EXPECT_EQ(std::get<TakeoffTask>(*checked).height, 40);
}

TEST_F(CheckedTask, FliesAsFastAsUsualIfNobodySaysHowFast) {
  const auto checked = task("goto", Parameters{}.add("waypoints", {100, 0, 50, 100, 100, 50}));
  ASSERT_TRUE(checked) << checked.error().why;
  EXPECT_EQ(std::get<GotoTask>(*checked).speed, 5);
  EXPECT_EQ(std::get<GotoTask>(*checked).waypoints.size(), 2U);
}

TEST_F(CheckedTask, IsRefusedForEveryReasonAtOnce) {
  state.airborne = false;
  engine_works = false;
  EXPECT_THAT(
      refusal("goto",
              Parameters{}.add("waypoints", {600, 0, 50, 0, 0, 1, 0, 0, 150}).add("speed", 11)),
      AllOf(HasSubstr("way-point 1 is outside the terrain"),
            HasSubstr("way-point 2 is only 1 m above the ground"),
            HasSubstr("way-point 3 is 150 m above the ground, over the ceiling of 100 m"),
            HasSubstr("speed 11 m/s is not within what it can fly"), HasSubstr("engine failure"),
            HasSubstr("before takeoff")));
}

TEST_F(CheckedTask, IsNoTakeoffInTheAirNorALandingOnTheGround) {
  EXPECT_THAT(refusal("takeoff", Parameters{}.add("altitude", 40)),
              HasSubstr("already in the air"));
  EXPECT_EQ(refusal("land"), "");
  state.airborne = false;
  EXPECT_THAT(refusal("land"), HasSubstr("already on the ground"));
  EXPECT_THAT(refusal("takeoff"), HasSubstr("altitude is missing"));
  EXPECT_THAT(refusal("takeoff", Parameters{}.add("altitude", 101)),
              HasSubstr("the ceiling of 100 m"));
}

TEST_F(CheckedTask, NeedsItsEnergyAboveTheReserve) {
  const auto far = Parameters{}.add("waypoints", {400, 400, 50});
  model.energy.hover_power = model.energy.cruise_power = 1000;
  EXPECT_EQ(refusal("goto", far), "");
  state.energy = model.energy.reserve + 0.01;
  EXPECT_THAT(refusal("goto", far), HasSubstr("10 kJ are left above the reserve"));
}

TEST_F(CheckedTask, NamesADeviceAndATypeThatMayBeMeant) {
  EXPECT_THAT(refusal("takeshot", Parameters{}.add("device", "visibel")),
              HasSubstr("did you mean 'visible'?"));
  EXPECT_THAT(refusal("gotoo"), HasSubstr("did you mean 'goto'?"));
  EXPECT_THAT(refusal("perceive", Parameters{}.add("device", "visible")),
              HasSubstr("duration is missing"));
  EXPECT_EQ(refusal("monitor", Parameters{}.add("device", "visible")), "");
}

TEST_F(CheckedTask, OfAGroundVehicleIsNeitherTakeoffNorLandingAndNeedsNoHeight) {
  model.ground.emplace().steepest = 0.3;
  state.airborne = false;
  EXPECT_THAT(refusal("takeoff", Parameters{}.add("altitude", 40)),
              HasSubstr("it keeps to the ground"));
  EXPECT_THAT(refusal("land"), HasSubstr("it keeps to the ground"));
  const auto checked = task("goto", Parameters{}.add("waypoints", {100, 0, 77}));
  ASSERT_TRUE(checked) << checked.error().why;
  EXPECT_EQ(std::get<GotoTask>(*checked).waypoints.front().z(), 0);
}

}  // namespace
}  // namespace skein::elementary
