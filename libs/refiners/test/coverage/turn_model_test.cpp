// SPDX-License-Identifier: Apache-2.0
#include "coverage/turn_model.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "skein/foundation/random.hpp"
#include "skein/refiners/coverage.hpp"
#include "testing/builders.hpp"

namespace skein::refiners {
namespace {

using testing::fixed_wing;
using testing::helicopter;
using world::Vector2;
constexpr double kPi = std::numbers::pi;

Pass eastward(double from, double to, double y) { return {{from, y}, {to, y}, 0}; }
Pass westward(double from, double to, double y) { return {{from, y}, {to, y}, kPi}; }

/// Flies from rest to rest over `length` in small steps, braking as late as it can.
double flown_in_steps(double length, double speed, double acceleration) {
  constexpr double kStep = 1e-4;
  double at = 0, v = 0, time = 0;
  while (at < length && time < 1000) {
    const bool brake = v * v / (2 * acceleration) >= length - at;
    v = brake ? std::max(v - acceleration * kStep, 1e-3)
              : std::min(v + acceleration * kStep, speed);
    at += v * kStep;
    time += kStep;
  }
  return time;
}

TEST(TurnModel, RestToRestTakesWhatAFlightInSmallStepsTakes) {
  const TurnModel model(helicopter(), 10);

  for (const double length : {1.0, 10.0, 49.0, 51.0, 300.0})
    EXPECT_NEAR(model.along(length), flown_in_steps(length, 10, 2), 0.04) << length;
}

TEST(TurnModel, HoveringMovesOverAndTurnsRoundAtTheSameTime) {
  const TurnModel model(helicopter(), 10);

  EXPECT_DOUBLE_EQ(model.between(eastward(0, 100, 0), westward(100, 0, 1)), kPi)
      << "a short move: the yaw takes longer";
  EXPECT_DOUBLE_EQ(model.between(eastward(0, 100, 0), westward(100, 0, 200)), 20 + 5)
      << "a long one: the yaw is done on the way";
}

TEST(TurnModel, TurnTimeAddsBrakingAndGatheringSpeedToTheMove) {
  EXPECT_DOUBLE_EQ(turn_time(helicopter(), 200, 10), (20 + 5) + 5);
  EXPECT_DOUBLE_EQ(turn_time(helicopter(), 1, 10), kPi + 5);
  EXPECT_DOUBLE_EQ(turn_time(helicopter(), 200), turn_time(helicopter(), 200, 10));
}

TEST(TurnModel, TurnTimeOfOneThatCannotHoverIsItsShortestCurve) {
  const world::VehicleModel vehicle = fixed_wing();

  for (double spacing = 0.5; spacing < 300; spacing += 3.7) {
    const DubinsCurve curve =
        DubinsCurve::shortest({{0, 0}, 0}, {{0, spacing}, kPi}, vehicle.min_turn_radius);
    EXPECT_NEAR(turn_time(vehicle, spacing, 20), curve.length() / 20, 1e-9) << spacing;
  }
}

TEST(TurnModel, BetweenLanesItFliesTheShortestCurve) {
  const TurnModel model(fixed_wing(), 15);
  Random random(3);

  for (int i = 0; i < 20'000; ++i) {
    const Pass from = random.chance(0.5) ? eastward(0, 50, 0) : westward(50, 0, 0);
    const double x = random.uniform(-300, 300), y = random.uniform(-300, 300);
    const Pass to = random.chance(0.5) ? eastward(x, x + 50, y) : westward(x, x - 50, y);
    const double curve = DubinsCurve::shortest(from.end(), to.begin(), 40).length();
    ASSERT_NEAR(model.between(from, to), curve / 15, 1e-6) << x << " " << y;
  }
}

TEST(TurnModel, ArrivesFromAPointNoLaterThanWithAnyOfManyHeadings) {
  const TurnModel model(fixed_wing(), 15);
  const Pass first = eastward(0, 100, 0);
  Random random(4);

  for (int i = 0; i < 200; ++i) {
    const Vector2 start(random.uniform(-400, 400), random.uniform(-400, 400));
    if ((start - Vector2(0, 40)).norm() < 41 || (start - Vector2(0, -40)).norm() < 41) continue;
    double least = 1e300;
    for (int k = 0; k < 720; ++k)
      least = std::min(
          least, DubinsCurve::shortest({start, k * kPi / 360}, first.begin(), 40).length() / 15);
    EXPECT_LE(model.reach(start, first), least + 1e-9);
    EXPECT_NEAR(arrival(start, first.begin(), 40).length() / 15, model.reach(start, first), 1e-6);
  }
}

TEST(TurnModel, LeavesForAPointAsItWouldArriveFromIt) {
  const TurnModel model(fixed_wing(), 15);
  Random random(5);

  for (int i = 0; i < 200; ++i) {
    const Vector2 end(random.uniform(-400, 400), random.uniform(-400, 400));
    const Pass last = eastward(0, 100, 0);
    const Pass back = westward(100, 0, 0);
    EXPECT_NEAR(model.leave(last, end), model.reach(end, back), 1e-9);
    EXPECT_NEAR((departure(last.end(), end, 40).at(1e9).at - end).norm(), 0, 1e-6);
  }
}

TEST(TurnModel, APlaceWithinTheTurnIsReachedByTheOtherSide) {
  const TurnModel model(fixed_wing(), 15);

  EXPECT_GT(model.leave(eastward(0, 100, 0), {100, 40}), 0) << "the centre of its left turn";
  EXPECT_DOUBLE_EQ(model.leave(eastward(0, 100, 0), {100, 0}), 0);
}

}  // namespace
}  // namespace skein::refiners
