// SPDX-License-Identifier: Apache-2.0
#include "skein/elementary/view_of.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "skein/foundation/random.hpp"

namespace skein::elementary {
namespace {

using world::Vector3;

constexpr double kPi = std::numbers::pi;

world::SensorModel camera(bool gimballed) {
  world::SensorModel sensor;
  sensor.device = "visible";
  sensor.aperture = 0.3;
  sensor.boresight_pitch = -0.6;
  sensor.gimballed = gimballed;
  sensor.range = 200;
  return sensor;
}

Vector3 somewhere(Random& random) {
  return {random.uniform(-500, 500), random.uniform(-500, 500), random.uniform(0, 300)};
}

world::VehicleState drawn_state(Random& random) {
  world::VehicleState state;
  state.position = somewhere(random);
  state.heading = random.uniform(-kPi, kPi);
  return state;
}

/// East, north and up by hand, not through the geometry that is under test.
Vector3 ahead(double heading, double pitch) {
  return {std::cos(heading) * std::cos(pitch), std::sin(heading) * std::cos(pitch),
          std::sin(pitch)};
}

TEST(ViewOf, AGimballedCameraHasItsTargetOnItsAxis) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const world::VehicleState state = drawn_state(random);
    const Vector3 target = somewhere(random), towards = target - state.position;

    const world::View view = view_of(camera(true), state, target, 0);

    EXPECT_NEAR(view.direction.norm(), 1, 1e-12);
    EXPECT_NEAR(view.direction.cross(towards).norm(), 0, 1e-9 * towards.norm());
    EXPECT_GT(view.direction.dot(towards), 0);
    EXPECT_EQ(view.viewpoint, state.position);
  }
}

TEST(ViewOf, AnErrorTurnsItAroundTheVerticalOnly) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const world::VehicleState state = drawn_state(random);
    const Vector3 target = somewhere(random);
    const double error = random.uniform(-0.5, 0.5);

    const Vector3 meant = view_of(camera(true), state, target, 0).direction;
    const Vector3 turned = view_of(camera(true), state, target, error).direction;

    EXPECT_NEAR(turned.z(), meant.z(), 1e-12);
    EXPECT_NEAR(turned.x(), meant.x() * std::cos(error) - meant.y() * std::sin(error), 1e-12);
    EXPECT_NEAR(turned.y(), meant.x() * std::sin(error) + meant.y() * std::cos(error), 1e-12);
  }
}

TEST(ViewOf, AFixedCameraLooksAheadWhateverItIsAskedFor) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const world::VehicleState state = drawn_state(random);

    const world::View view = view_of(camera(false), state, somewhere(random), 0.2);

    EXPECT_NEAR((view.direction - ahead(state.heading, -0.6)).norm(), 0, 1e-12);
    EXPECT_EQ(view.range, 200);
    EXPECT_EQ(view.aperture, 0.3);
  }
}

TEST(ViewOf, WithoutATargetOrWithItselfForOneAGimballedCameraLooksAhead) {
  world::VehicleState state;
  state.position = {10, 20, 30};
  state.heading = 2;

  for (const std::optional<Vector3>& target :
       {std::optional<Vector3>(), std::optional(state.position)})
    EXPECT_NEAR((view_of(camera(true), state, target, 0.1).direction - ahead(2, -0.6)).norm(), 0,
                1e-12);
}

TEST(ViewOf, StraightDownIsDownAlmostOrExactly) {
  world::VehicleState state;
  state.position = {0, 0, 100};

  for (const double aside : {0.0, 1e-300, 1e-160, 1e-9, 1e-5}) {
    const Vector3 seen = view_of(camera(true), state, Vector3(aside, -aside, 0), 0).direction;

    EXPECT_NEAR((seen - Vector3(0, 0, -1)).norm(), 0, 1e-6) << aside;
  }
}

}  // namespace
}  // namespace skein::elementary
