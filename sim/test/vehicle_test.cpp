// SPDX-License-Identifier: Apache-2.0
#include "vehicle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "testing.hpp"

namespace skein::sim {
namespace {

using testing::model_of;
using world::Vector2;
using world::Vector3;

constexpr double kStep = 0.1;
constexpr double kRounding = 1e-9;

world::Terrain level(double height) {
  world::TerrainSpec spec = testing::flat_spec();
  spec.base = height;
  return world::Terrain(spec);
}

const world::Terrain kLevel = testing::flat();

Vehicle flying(const world::VehicleModel& model, double height = 100) {
  Vehicle vehicle(model, {0, 0, height}, 0, 1);
  vehicle.step({model.cruise_speed, 0, 0.01, std::nullopt, true}, Vector3::Zero(), kLevel, kStep);
  return vehicle;
}

/// Any command at all, also far beyond what the vehicle can do.
rc::Gen<Command> any_command() {
  const auto figure = [](int most) {
    return rc::gen::map(rc::gen::inRange(-1000, 1001), [most](int n) { return n * 0.001 * most; });
  };
  return rc::gen::build<Command>(rc::gen::set(&Command::speed, figure(60)),
                                 rc::gen::set(&Command::course, figure(10)),
                                 rc::gen::set(&Command::climb, figure(20)),
                                 rc::gen::set(&Command::may_touch, rc::gen::just(true)));
}

rc::Gen<std::string> any_model() {
  return rc::gen::element<std::string>("marvin", "heliv", "karma");
}

RC_GTEST_PROP(Vehicle, NeverExceedsItsSpeedsAndAcceleration, ()) {
  const world::VehicleModel model = model_of(*any_model());
  Vehicle vehicle = flying(model);

  for (const Command& command : *rc::gen::container<std::vector<Command>>(60, any_command())) {
    const Vector3 before = vehicle.air_velocity();
    vehicle.step(command, Vector3::Zero(), kLevel, kStep);
    const Vector3& after = vehicle.air_velocity();

    RC_ASSERT(after.head<2>().norm() <= model.max_speed + kRounding);
    if (!vehicle.state().airborne) continue;  // the ground stops it at once
    RC_ASSERT(after.z() <= model.climb_rate + kRounding);
    RC_ASSERT(after.z() >= -model.descent_rate - kRounding);
    RC_ASSERT(std::abs(after.z() - before.z()) <= model.acceleration * kStep + kRounding);
    const double along = std::abs(after.head<2>().norm() - before.head<2>().norm());
    RC_ASSERT(along <= model.acceleration * kStep + kRounding);
    if (model.hovers)
      RC_ASSERT((after - before).head<2>().norm() <= model.acceleration * kStep + kRounding);
  }
}

RC_GTEST_PROP(Vehicle, NeverTurnsTighterThanItsRadius, ()) {
  const world::VehicleModel model = model_of("karma");
  Vehicle vehicle = flying(model);

  for (const Command& command : *rc::gen::container<std::vector<Command>>(60, any_command())) {
    const double before = vehicle.state().heading;
    vehicle.step(command, Vector3::Zero(), kLevel, kStep);

    const double turn = std::abs(world::wrapped(vehicle.state().heading - before));
    const double flown = vehicle.air_velocity().head<2>().norm() * kStep;
    RC_ASSERT(turn * model.min_turn_radius <= flown + kRounding);
  }
}

RC_GTEST_PROP(Vehicle, EnergyNeverGrowsAndStaysWithinItsRange, ()) {
  world::VehicleModel model = model_of(*any_model());
  model.energy.capacity = 2000;  // little, so that it runs out
  Vehicle vehicle = flying(model);

  for (const Command& command : *rc::gen::container<std::vector<Command>>(60, any_command())) {
    const double before = vehicle.state().energy;
    vehicle.step(command, Vector3::Zero(), kLevel, kStep);
    RC_ASSERT(vehicle.state().energy <= before);
    RC_ASSERT(vehicle.state().energy >= 0);
  }
}

RC_GTEST_PROP(Vehicle, IsNeverUnderTheGround, ()) {
  Vehicle vehicle = flying(model_of(*any_model()), 5);

  for (const Command& command : *rc::gen::container<std::vector<Command>>(80, any_command())) {
    vehicle.step(command, Vector3::Zero(), kLevel, kStep);
    RC_ASSERT(vehicle.state().position.z() >= 0);
  }
}

TEST(Vehicle, TheWindAddsItsDriftToTheVelocityOverTheGround) {
  const world::VehicleModel model = model_of("karma");
  Vehicle vehicle = flying(model);

  vehicle.step({model.cruise_speed, 0, 0, std::nullopt, false}, {0, 5, 0}, kLevel, kStep);

  EXPECT_NEAR(vehicle.state().velocity.y(), model.wind_drift * 5, 1e-12);
}

TEST(Vehicle, OneThatCannotHoverKeepsItsLeastSpeed) {
  const world::VehicleModel model = model_of("karma");
  Vehicle vehicle = flying(model);

  for (int i = 0; i < 600; ++i) vehicle.step({}, Vector3::Zero(), kLevel, kStep);

  EXPECT_NEAR(vehicle.air_velocity().head<2>().norm(), model.min_speed, 1e-9);
}

TEST(Vehicle, StaysOnTheGroundUntilToldToClimb) {
  Vehicle vehicle(model_of("marvin"), {3, 4, 7}, 0, 1);

  for (int i = 0; i < 10; ++i) vehicle.step({5, 0, 0}, {3, 0, 0}, level(7), kStep);

  EXPECT_FALSE(vehicle.state().airborne);
  EXPECT_EQ(vehicle.state().position, Vector3(3, 4, 7));
}

TEST(Vehicle, FlyingIntoASlopeIsACrashAlsoWhileItClimbs) {
  const world::Terrain hill = testing::with_hill(100, 0, 60, 80);  // 1.2 m/m half-way up
  Vehicle vehicle = flying(model_of("marvin"), 10);

  for (int i = 0; i < 600 && !vehicle.crashed(); ++i)
    vehicle.step({5, 0, 1}, Vector3::Zero(), hill, kStep);

  EXPECT_TRUE(vehicle.crashed());
  const Vector3& at = vehicle.state().position;
  EXPECT_NEAR(at.z(), hill.elevation(at.x(), at.y()), 1e-9) << "it lies on the slope";
}

TEST(Vehicle, TakingOffWhileTheWindDrivesItUpASlopeIsNone) {
  const world::Terrain hill = testing::with_hill(100, 0, 60, 80);
  Vehicle vehicle(model_of("marvin"), {60, 0, hill.elevation(60, 0)}, 0, 1);
  const double climb = model_of("marvin").climb_rate;

  for (int i = 0; i < 300; ++i) {
    vehicle.step({0, 0, climb, std::nullopt, true}, {5, 0, 0}, hill, kStep);
    const Vector3& at = vehicle.state().position;
    ASSERT_GE(at.z(), hill.elevation(at.x(), at.y())) << "after " << i + 1 << " steps";
  }

  EXPECT_TRUE(vehicle.state().airborne);
  EXPECT_FALSE(vehicle.crashed());
}

TEST(Vehicle, MeetingTheGroundUnmeantIsACrash) {
  Vehicle vehicle = flying(model_of("marvin"), 1);

  for (int i = 0; i < 100; ++i) vehicle.step({5, 0, -2}, Vector3::Zero(), kLevel, kStep);

  EXPECT_TRUE(vehicle.crashed());
  EXPECT_FALSE(vehicle.engine_works());
  EXPECT_FALSE(vehicle.state().airborne);
}

TEST(Vehicle, MeetingTheGroundMeantIsALanding) {
  Vehicle vehicle = flying(model_of("marvin"), 1);

  for (int i = 0; i < 100; ++i)
    vehicle.step({0, 0, -0.5, std::nullopt, true}, Vector3::Zero(), kLevel, kStep);

  EXPECT_FALSE(vehicle.crashed());
  EXPECT_FALSE(vehicle.state().airborne);
  EXPECT_EQ(vehicle.state().velocity, Vector3::Zero());
}

TEST(Vehicle, SinksWithoutEngineWhateverItIsTold) {
  const world::VehicleModel model = model_of("marvin");
  Vehicle vehicle = flying(model, 20);
  vehicle.break_engine();

  for (int i = 0; i < 300; ++i) vehicle.step({8, 0, 3}, Vector3::Zero(), kLevel, kStep);

  EXPECT_FALSE(vehicle.state().airborne);
  EXPECT_EQ(vehicle.state().position.z(), 0);
  EXPECT_FALSE(vehicle.crashed());
}

TEST(Vehicle, DrawsWhatItsModelSays) {
  const world::VehicleModel model = model_of("marvin");
  Vehicle vehicle(model, Vector3::Zero(), 0, 1);

  for (int i = 0; i < 100; ++i) vehicle.step({}, Vector3::Zero(), kLevel, kStep);

  EXPECT_NEAR((1 - vehicle.state().energy) * model.energy.capacity, model.energy.ground_power * 10,
              1e-6);
}

TEST(Vehicle, HoveringItTurnsToTheHeadingAskedNoFasterThanItsYawRate) {
  const world::VehicleModel model = model_of("marvin");
  Vehicle vehicle = flying(model);

  double fastest = 0;
  for (int i = 0; i < 100; ++i) {
    const double before = vehicle.state().heading;
    vehicle.step({0, 0, 0, 2.0, false}, Vector3::Zero(), kLevel, kStep);
    fastest = std::max(fastest, std::abs(world::wrapped(vehicle.state().heading - before)));
  }

  EXPECT_NEAR(vehicle.state().heading, 2.0, 1e-9);
  EXPECT_LE(fastest, model.yaw_rate * kStep + 1e-12);
}

}  // namespace
}  // namespace skein::sim
