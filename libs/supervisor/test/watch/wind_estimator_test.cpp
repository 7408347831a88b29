// SPDX-License-Identifier: Apache-2.0
// The wind from how a vehicle is carried over the ground. Against the simulator:
// tests/scenarios/felt_wind_test.cpp.
#include "watch/wind_estimator.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "skein/foundation/random.hpp"

namespace skein::supervisor {
namespace {

using world::Vector3;

world::VehicleModel blimp() {
  world::VehicleModel model;
  model.hovers = false;
  model.cruise_speed = 8;
  model.wind_drift = 1;
  return model;
}

world::VehicleModel helicopter() {
  world::VehicleModel model = blimp();
  model.hovers = true;
  model.wind_drift = 0.5;
  return model;
}

world::VehicleState flying(const world::VehicleModel& model, double heading, double air_speed,
                           const Vector3& wind) {
  world::VehicleState state;
  state.airborne = true;
  state.heading = heading;
  state.velocity =
      air_speed * Vector3(std::cos(heading), std::sin(heading), 0) + model.wind_drift * wind;
  return state;
}

double error(const WindEstimator& estimator, const Vector3& wind) {
  return (world::mean_velocity(estimator.wind()) - wind).norm();
}

TEST(WindEstimator, BeginsWithWhatIsBelieved) {
  const world::Wind believed{0.6, 2, 0.5};
  const WindEstimator estimator(blimp(), believed);

  EXPECT_NEAR(estimator.wind().toward, 0.6, 1e-9);
  EXPECT_NEAR(estimator.wind().speed, 2, 1e-9);
  EXPECT_EQ(estimator.wind().gusts, 0.5);
  EXPECT_GT(estimator.spread(), 1) << "and is not sure of it";
}

RC_GTEST_PROP(WindEstimator, FindsTheWindAndTheAirSpeedOfACircle, ()) {
  const double toward = *rc::gen::inRange(0, 628) / 100.0, speed = *rc::gen::inRange(0, 60) / 10.0;
  const Vector3 wind(speed * std::cos(toward), speed * std::sin(toward), 0);
  const double air_speed = *rc::gen::inRange(72, 88) / 10.0;
  WindEstimator estimator(blimp(), {0, 0, 0.5});

  for (int s = 0; s < 240; ++s)
    estimator.see(flying(blimp(), 0.1 * s, air_speed, wind), MissionTime::seconds(s));

  RC_ASSERT(error(estimator, wind) < 0.15);
  RC_ASSERT(estimator.spread() < 0.6);
}

TEST(WindEstimator, OfStraightFlightKnowsWhatIsAcrossOnly) {
  const Vector3 wind(3, 2, 0);
  WindEstimator estimator(helicopter(), {0, 0, 0.5});

  for (int s = 0; s < 300; ++s)
    estimator.see(flying(helicopter(), 0, 8, wind), MissionTime::seconds(s));

  EXPECT_NEAR(world::mean_velocity(estimator.wind()).y(), 2, 0.2);
  EXPECT_GT(estimator.spread(), 0.6) << "along it, wind and air speed cannot be told apart";
}

TEST(WindEstimator, OfTwoDirectionsAcrossKnowsBoth) {
  const Vector3 wind(-2.5, 1, 0);
  WindEstimator estimator(helicopter(), {0, 0, 0.5});

  for (int s = 0; s < 400; ++s)
    estimator.see(flying(helicopter(), (s / 100) * M_PI / 2, 7.5, wind), MissionTime::seconds(s));

  EXPECT_LT(error(estimator, wind), 0.3);
}

TEST(WindEstimator, LearnsNothingFromHoveringOrOnTheGround) {
  WindEstimator estimator(helicopter(), {0, 0, 0.5});
  const double before = estimator.spread();
  world::VehicleState hovering;
  hovering.airborne = true;
  world::VehicleState landed = flying(helicopter(), 1, 8, {3, 0, 0});
  landed.airborne = false;

  for (int s = 0; s < 100; ++s) estimator.see(hovering, MissionTime::seconds(s));
  for (int s = 100; s < 200; ++s) estimator.see(landed, MissionTime::seconds(s));

  EXPECT_EQ(estimator.spread(), before);
  EXPECT_EQ(estimator.wind().speed, 0);
}

TEST(WindEstimator, StaysCloseThroughGusts) {
  const Vector3 wind(2, -3, 0);
  Random random(5, "gusts");
  WindEstimator estimator(blimp(), {0, 0, 0.8});

  for (int s = 0; s < 600; ++s) {
    const Vector3 gust(random.uniform(-1.4, 1.4), random.uniform(-1.4, 1.4), 0);
    estimator.see(flying(blimp(), 0.05 * s, 8, wind + gust), MissionTime::seconds(s));
  }

  EXPECT_LT(error(estimator, wind), 0.5);
}

// A fault of the vehicle, that lasts for two minutes.
TEST(WindEstimator, TakesNoVehicleThatBecomesSlowForAWind) {
  const Vector3 wind(1, 0, 0);
  WindEstimator estimator(blimp(), {0, 1, 0.3});
  double worst = 0;

  for (int s = 0; s < 600; ++s) {
    const double air_speed = s >= 150 && s < 270 ? 5.5 : 8;
    const double heading = s < 300 ? 0.1 * std::min(s, 140) : 14;
    estimator.see(flying(blimp(), heading, air_speed, wind), MissionTime::seconds(s));
    if (estimator.spread() < 0.6) worst = std::max(worst, error(estimator, wind));
  }

  EXPECT_LT(worst, 1);
}

TEST(WindEstimator, OfAVehicleThatWasAlwaysSlowKnowsTheWindAllTheSame) {
  WindEstimator estimator(blimp(), {0, 0, 0.3});
  double worst = 0;

  for (int s = 0; s < 400; ++s) {
    estimator.see(flying(blimp(), 0.05 * s, 4.5, Vector3::Zero()), MissionTime::seconds(s));
    if (estimator.spread() < 0.6) worst = std::max(worst, error(estimator, Vector3::Zero()));
  }

  EXPECT_LT(worst, 0.75);
  EXPECT_LT(estimator.spread(), 0.6);
}

TEST(WindEstimator, FollowsAWindThatTurns) {
  WindEstimator estimator(blimp(), {0, 0, 0.5});
  for (int s = 0; s < 300; ++s)
    estimator.see(flying(blimp(), 0.1 * s, 8, {3, 0, 0}), MissionTime::seconds(s));

  for (int s = 300; s < 1500; ++s)
    estimator.see(flying(blimp(), 0.1 * s, 8, {0, 3, 0}), MissionTime::seconds(s));

  EXPECT_LT(error(estimator, {0, 3, 0}), 0.8);
}

}  // namespace
}  // namespace skein::supervisor
