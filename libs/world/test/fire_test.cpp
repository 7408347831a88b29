// SPDX-License-Identifier: Apache-2.0
// Fires against what an elliptical fire is: an oracle that steps rays, and laws over random ones.
#include "skein/world/fire.hpp"

#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "skein/foundation/random.hpp"

namespace skein::world {
namespace {

FireSpread in_wind(double speed, double toward = 0) {
  FireSpread spread;
  spread.rate = 0.1;
  spread.gain = 0.5;
  spread.wind = {toward, speed, 0};
  return spread;
}

FireFront after(const FireSpread& spread, double seconds, double radius = 0) {
  return front_of(spread, {100, 50}, radius, Duration::seconds(seconds));
}

TEST(FireFront, InCalmAirIsACircleAboutItsIgnition) {
  const FireFront front = after(in_wind(0), 100);

  EXPECT_EQ(front.centre(), Vector2(100, 50));
  EXPECT_NEAR(front.length, 10, 1e-9);
  EXPECT_NEAR(front.breadth, 10, 1e-9);
}

// 0.1 m/s, twice as fast in 2 m/s of wind with a gain of 0.5 s/m.
TEST(FireFront, ItsHeadGoesWithTheWindAtTheRateThatTheWindGives) {
  const FireFront front = after(in_wind(2, std::numbers::pi / 2), 100);

  EXPECT_NEAR(front.head().x(), 100, 1e-9);
  EXPECT_NEAR(front.head().y(), 50 + 20, 1e-6);
}

TEST(FireFront, ReachesAsFarAheadAtFirstAsItIsSaidTo) {
  EXPECT_NEAR((after(in_wind(3), 0, 5).head() - Vector2(100, 50)).norm(), 5, 1e-9);
  EXPECT_EQ(after(in_wind(3), -10, 5), after(in_wind(3), 0, 5)) << "before it appears";
}

// Length to breadth as Anderson measured it, by his formula worked out by hand.
TEST(FireFront, IsTheMoreSlenderTheStrongerTheWind) {
  const auto ratio = [](double wind) {
    const FireFront front = after(in_wind(wind), 100);
    return front.length / front.breadth;
  };

  EXPECT_NEAR(ratio(0), 1, 1e-6);
  EXPECT_NEAR(ratio(2), 1.50496, 1e-4);
  EXPECT_NEAR(ratio(5), 3.19217, 1e-4);
  EXPECT_NEAR(ratio(20), 8, 1e-6) << "beyond what was measured";
}

TEST(FireFront, ItsOutlineLiesOnItFromTheHeadOn) {
  const FireFront front = after(in_wind(4, 1), 200);
  const auto outline = front.outline(12);

  ASSERT_EQ(outline.size(), 12U);
  EXPECT_NEAR((outline[0] - front.head()).norm(), 0, 1e-9);
  for (const Vector2& point : outline) {
    const Vector2 out = front.centre() + 1.001 * (point - front.centre());
    EXPECT_TRUE(front.contains(front.centre() + 0.999 * (point - front.centre())));
    EXPECT_FALSE(front.contains(out));
    EXPECT_LT(front.distance_to(out), 0.1);
  }
}

struct Drawn {
  FireSpread spread;
  double radius = 0, seconds = 0;
  Vector2 point = Vector2::Zero();
};

Drawn draw(std::uint64_t seed) {
  Random random(seed);
  Drawn drawn;
  drawn.spread.rate = random.uniform(0.01, 1);
  drawn.spread.gain = random.uniform(0, 1);
  drawn.spread.wind = {random.uniform(0, 6.28), random.uniform(0, 15), random.uniform(0, 2)};
  drawn.radius = random.uniform(0, 20);
  drawn.seconds = random.uniform(0, 2000);
  drawn.point = {100 + random.uniform(-300, 300), 50 + random.uniform(-300, 300)};
  return drawn;
}

// When a point burns, and what burns then, are two ways to say one thing.
RC_GTEST_PROP(FireFront, APointBelongsToItFromWhenTheFireArrives, (std::uint64_t seed)) {
  const Drawn d = draw(seed);
  const Duration arrival = arrival_at(d.spread, {100, 50}, d.radius, d.point);
  RC_PRE(arrival > Duration::seconds(1) && arrival < Duration::seconds(1e6));
  const double at = arrival.to_seconds();

  RC_ASSERT(
      !front_of(d.spread, {100, 50}, d.radius, Duration::seconds(at * 0.999)).contains(d.point));
  RC_ASSERT(
      front_of(d.spread, {100, 50}, d.radius, Duration::seconds(at * 1.001)).contains(d.point));
}

RC_GTEST_PROP(FireFront, WhatHasBurntGoesOnToBelongToIt, (std::uint64_t seed)) {
  const Drawn d = draw(seed);
  const FireFront before = after(d.spread, d.seconds, d.radius);
  const FireFront later = after(d.spread, d.seconds * 1.3 + 1, d.radius);

  for (const Vector2& point : before.outline(32)) RC_ASSERT(later.distance_to(point) < 1e-6);
}

// Against the nearest of many points of it.
RC_GTEST_PROP(FireFront, ADistanceIsToTheNearestPointOfIt, (std::uint64_t seed)) {
  const Drawn d = draw(seed);
  const FireFront front = after(d.spread, d.seconds + 1, d.radius);
  RC_PRE(!front.contains(d.point));
  double nearest = 1e9;
  for (const Vector2& point : front.outline(4000))
    nearest = std::min(nearest, (point - d.point).norm());

  RC_ASSERT(std::abs(front.distance_to(d.point) - nearest) < 0.002 * front.length + 1e-3);
}

// Every point that burns lights the same ellipse anew (Huygens): no point is passed by.
RC_GTEST_PROP(FireFront, IsWhatItsOwnPointsLightInTurn, (std::uint64_t seed)) {
  const Drawn d = draw(seed);
  const double first = d.seconds / 2 + 1, second = d.seconds / 3 + 1;
  const FireFront whole = after(d.spread, first + second);
  const FireFront half = after(d.spread, first);

  for (const Vector2& spark : half.outline(24)) {
    const FireFront lit = front_of(d.spread, spark, 0, Duration::seconds(second));
    for (const Vector2& point : lit.outline(24)) RC_ASSERT(whole.distance_to(point) < 1e-6);
  }
  const FireFront from_head = front_of(d.spread, half.head(), 0, Duration::seconds(second));
  RC_ASSERT((from_head.head() - whole.head()).norm() < 1e-6);
}

}  // namespace
}  // namespace skein::world
