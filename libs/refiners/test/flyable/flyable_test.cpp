// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/flyable.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "skein/foundation/random.hpp"
#include "skein/refiners/dubins.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;
constexpr double kPi = std::numbers::pi;
constexpr double kTolerance = 0.5;

/// As the blimp of the scenarios: slow, wide turns.
world::VehicleModel a_blimp() {
  world::VehicleModel vehicle;
  vehicle.name = "karma";
  vehicle.kind = world::VehicleKind::kBlimp;
  vehicle.hovers = false;
  vehicle.min_speed = 2;
  vehicle.cruise_speed = 8;
  vehicle.max_speed = 11;
  vehicle.climb_rate = 1.5;
  vehicle.descent_rate = 1.2;
  vehicle.acceleration = 0.5;
  vehicle.min_turn_radius = 25;
  vehicle.orbit_radius = 40;
  vehicle.ceiling = 200;
  vehicle.energy.capacity = 3.5e6;
  vehicle.energy.cruise_power = 600;
  vehicle.energy.hover_power = 250;
  return vehicle;
}

world::VehicleModel a_helicopter() {
  world::VehicleModel vehicle = a_blimp();
  vehicle.kind = world::VehicleKind::kHelicopter;
  vehicle.hovers = true;
  vehicle.min_speed = vehicle.min_turn_radius = vehicle.orbit_radius = 0;
  vehicle.yaw_rate = 0.6;
  return vehicle;
}

FlyableQuery query_of(Way corners) {
  FlyableQuery query;
  query.corners = std::move(corners);
  query.tolerance = kTolerance;
  return query;
}

double turn_at(const std::vector<Vector2>& plane, std::size_t i) {
  const Vector2 in = plane[i] - plane[i - 1], out = plane[i + 1] - plane[i];
  return std::abs(world::wrapped(std::atan2(out.y(), out.x()) - std::atan2(in.y(), in.x())));
}

/// Between any two points the way never turns by more than the length between them allows: the law
/// of bounded curvature, checked on the samples without anything of the library. The chord of an
/// arc of at most π/4 is up to 2.6 % shorter than the arc.
void expect_bounded_turns(const Way& way, double radius) {
  std::vector<Vector2> plane;
  for (const Vector3& point : way)
    if (plane.empty() || (point.head<2>() - plane.back()).norm() > 1e-6)
      plane.emplace_back(point.head<2>());
  const double longest_chord = 2 * std::sqrt(2 * radius * kTolerance);
  for (std::size_t i = 1; i + 1 < plane.size(); ++i) {
    double turned = 0;
    double length = std::min((plane[i] - plane[i - 1]).norm(), longest_chord) / 2;
    for (std::size_t k = i; k + 1 < std::min(plane.size(), i + 40); ++k) {
      turned += turn_at(plane, k);
      const double next = (plane[k + 1] - plane[k]).norm();
      const double up_to = length + std::min(next, longest_chord) / 2;
      ASSERT_LE(turned, 1.027 * up_to / radius + 1e-4) << "from point " << i << " to " << k;
      length += next;
    }
  }
}

void expect_bounded_slopes(const Way& way, double climb, double descent) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vector3 leg = way[i] - way[i - 1];
    const double level = leg.head<2>().norm();
    ASSERT_LE(leg.z(), climb * level + 1e-5) << "leg " << i;
    ASSERT_GE(leg.z(), -descent * level - 1e-5) << "leg " << i;
  }
}

void expect_flyable(const Way& way, const world::VehicleModel& vehicle) {
  expect_bounded_turns(way, vehicle.min_turn_radius);
  expect_bounded_slopes(way, vehicle.climb_rate / vehicle.cruise_speed,
                        vehicle.descent_rate / vehicle.cruise_speed);
  EXPECT_TRUE(is_flyable(way, vehicle, 0, kTolerance));
}

struct Ball {
  Vector3 centre;
  double radius;
};

/// Balls in the air, and the ground at z = 0.
struct Clutter {
  std::vector<Ball> balls;

  bool holds(const Vector3& point) const {
    return point.z() < 0 || std::any_of(balls.begin(), balls.end(), [&](const Ball& ball) {
             return (point - ball.centre).norm() < ball.radius;
           });
  }
  bool is_free(const Vector3& a, const Vector3& b) const {
    if (std::min(a.z(), b.z()) < 0) return false;
    return std::none_of(balls.begin(), balls.end(), [&](const Ball& ball) {
      const Vector3 leg = b - a;
      const double square = leg.squaredNorm();
      const double t = square > 0 ? std::clamp((ball.centre - a).dot(leg) / square, 0.0, 1.0) : 0.0;
      return (a + t * leg - ball.centre).norm() < ball.radius;
    });
  }
};

void expect_clear(const Way& way, const Clutter& clutter) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double length = (way[i] - way[i - 1]).norm();
    const int steps = 1 + static_cast<int>(length / 0.25);
    for (int k = 0; k <= steps; ++k) {
      const Vector3 point = way[i - 1] + (way[i] - way[i - 1]) * k / steps;
      // A hair off, for rounding of the exact test.
      ASSERT_FALSE(clutter.holds(point + Vector3(0, 0, 1e-9)) && clutter.holds(point))
          << point.transpose();
    }
  }
}

double heading_of(const Vector3& from, const Vector3& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

double level_length(const Way& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).head<2>().norm();
  return length;
}

TEST(Flyable, AStraightWayStaysAsItIs) {
  const Way straight = {{0, 0, 50}, {400, 300, 60}};

  const auto way = make_flyable(query_of(straight), a_blimp());

  ASSERT_TRUE(way.has_value());
  EXPECT_EQ(*way, straight);
}

TEST(Flyable, ARightAngleIsRoundedInside) {
  const Way corners = {{0, 0, 50}, {300, 0, 50}, {300, 300, 50}};

  const auto way = make_flyable(query_of(corners), a_blimp());

  ASSERT_TRUE(way.has_value());
  expect_flyable(*way, a_blimp());
  EXPECT_EQ(way->front(), corners.front());
  EXPECT_EQ(way->back(), corners.back());
  // Two tangents of 25 m less, a quarter of a circle more.
  EXPECT_NEAR(level_length(*way), 600 - 50 + 25 * kPi / 2, 0.5);
}

TEST(Flyable, ACornerThatMayNotBeCutIsSwungAround) {
  FlyableQuery query = query_of({{0, 0, 50}, {300, 0, 50}, {300, 300, 50}});
  const Clutter clutter{{{{292, 8, 50}, 11}}};  // touches the corner on its inside
  query.is_free = [&](const Vector3& a, const Vector3& b) { return clutter.is_free(a, b); };

  const auto way = make_flyable(query, a_blimp());

  ASSERT_TRUE(way.has_value()) << way.error().why;
  expect_flyable(*way, a_blimp());
  expect_clear(*way, clutter);
}

TEST(Flyable, HeadingsAtTheEndsAreKept) {
  FlyableQuery query = query_of({{0, 0, 50}, {300, 0, 50}});
  query.heading_from = kPi;
  query.heading_to = kPi / 2;

  const auto way = make_flyable(query, a_blimp());

  ASSERT_TRUE(way.has_value());
  expect_flyable(*way, a_blimp());
  const double chord = chord_angle(25, kTolerance);
  EXPECT_LE(std::abs(world::wrapped(heading_of((*way)[0], (*way)[1]) - kPi)), chord / 2 + 1e-6);
  const double last = heading_of((*way)[way->size() - 2], way->back());
  EXPECT_LE(std::abs(world::wrapped(last - kPi / 2)), chord / 2 + 1e-6);
}

TEST(Flyable, AClimbTooSteepIsTurnedInCircles) {
  const Way corners = {{0, 0, 20}, {200, 0, 180}};  // 160 m up, 37.5 m would be possible

  const auto way = make_flyable(query_of(corners), a_blimp());

  ASSERT_TRUE(way.has_value());
  expect_flyable(*way, a_blimp());
  const double needed = 160 / (1.5 / 8);
  EXPECT_GE(level_length(*way), needed - 1e-6);
  EXPECT_LE(level_length(*way), 1.002 * needed) << "no whole circle more than it takes";
}

/// Whole circles alone made half of them more than 5 % longer, and the worst half as long again.
TEST(Flyable, AClimbIsNoLongerThanItsSlopeAsksForWhateverTheHeadings) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const double rise = random.uniform(40, 150) * (random.chance(0.5) ? 1 : -1);
    FlyableQuery query = query_of({{0, 0, 200}, {random.uniform(120, 800), 0, 200 + rise}});
    if (random.chance(0.5)) query.heading_from = random.uniform(-kPi, kPi);
    if (random.chance(0.5)) query.heading_to = random.uniform(-kPi, kPi);
    const double needed = rise > 0 ? rise * 8 / 1.5 : -rise * 8 / 1.2;
    FlyableQuery level = query;
    level.corners.back().z() = 200;

    const auto way = make_flyable(query, a_blimp()), on_the_level = make_flyable(level, a_blimp());

    ASSERT_TRUE(way && on_the_level);
    expect_flyable(*way, a_blimp());
    EXPECT_LE(level_length(*way), 1.01 * std::max(needed, level_length(*on_the_level)) + 3);
  }
}

TEST(Flyable, AVerticalLegIsAHelix) {
  for (const double top : {10.0, 150.0}) {
    const Way corners = {{0, 0, 80}, {0, 0, top}};

    const auto way = make_flyable(query_of(corners), a_blimp());

    ASSERT_TRUE(way.has_value());
    expect_flyable(*way, a_blimp());
    EXPECT_EQ(way->back(), corners.back());
  }
}

TEST(Flyable, CornersTooCloseForItsTurnsAreLeftOut) {
  Way stairs;
  for (int i = 0; i <= 20; ++i) stairs.emplace_back(5 * i + 5 * (i % 2), 5 * i, 60);

  const auto way = make_flyable(query_of(stairs), a_blimp());

  ASSERT_TRUE(way.has_value());
  expect_flyable(*way, a_blimp());
  EXPECT_LE(level_length(*way), 1.25 * level_length(stairs) + 100);
}

TEST(Flyable, AVehicleThatHoversKeepsItsCorners) {
  const Way corners = {{0, 0, 10}, {0, 0, 150}, {5, 0, 10}, {-80, 3, 60}};

  const auto way = make_flyable(query_of(corners), a_helicopter());

  ASSERT_TRUE(way.has_value());
  EXPECT_EQ(*way, corners);
  EXPECT_TRUE(is_flyable(corners, a_helicopter(), 0, kTolerance));
}

TEST(Flyable, ALegThatIsNotFreeIsNamedForAVehicleThatHovers) {
  FlyableQuery query = query_of({{0, 0, 10}, {50, 0, 10}, {100, 0, 10}});
  query.is_free = [](const Vector3&, const Vector3& b) { return b.x() < 80; };

  const auto way = make_flyable(query, a_helicopter());

  ASSERT_FALSE(way.has_value());
  EXPECT_EQ(way.error().kind, RefusalKind::kBlocked);
  EXPECT_EQ(way.error().field, "corners.2");
}

TEST(Flyable, WhatCannotBeTurnedIsRefusedWithThePlace) {
  // A corridor 20 m wide with a right angle: far too narrow for turns of 25 m.
  FlyableQuery query = query_of({{0, 0, 50}, {300, 0, 50}, {300, 300, 50}});
  query.is_free = [](const Vector3& a, const Vector3& b) {
    const auto inside = [](const Vector3& p) {
      const bool first = std::abs(p.y()) <= 3 && p.x() <= 303;
      const bool second = std::abs(p.x() - 300) <= 3 && p.y() >= -3;
      return first || second;
    };
    for (int i = 0; i <= 50; ++i)
      if (!inside(a + (b - a) * i / 50.0)) return false;
    return true;
  };

  const auto way = make_flyable(query, a_blimp());

  ASSERT_FALSE(way.has_value());
  EXPECT_EQ(way.error().kind, RefusalKind::kBeyondVehicle);
  EXPECT_EQ(way.error().field, "corners.1");
  EXPECT_NE(way.error().why.find("25 m"), std::string::npos) << way.error().why;
  EXPECT_NE(way.error().why.find("(300.0, 0.0, 50.0)"), std::string::npos) << way.error().why;
}

TEST(Flyable, NothingFreeIsRefusedSoon) {
  FlyableQuery query = query_of({});
  Random random(2);
  for (int i = 0; i < 30; ++i)
    query.corners.emplace_back(random.uniform(0, 900), random.uniform(0, 900),
                               random.uniform(0, 190));
  std::uint64_t asked = 0;
  query.is_free = [&](const Vector3&, const Vector3&) { return ++asked % 200 != 0; };

  const auto way = make_flyable(query, a_blimp());

  EXPECT_LE(asked, 300'000U);
  if (way) expect_flyable(*way, a_blimp());
}

TEST(Flyable, FiguresThatMakeNoSenseAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Way good = {{0, 0, 50}, {300, 0, 50}};
  std::vector<FlyableQuery> queries(7, query_of(good));
  queries[0].corners = {{0, 0, 50}};
  queries[1].corners = {{0, 0, nan}, {300, 0, 50}};
  queries[2].heading_from = nan;
  queries[3].heading_to = std::numeric_limits<double>::infinity();
  queries[4].speed = -1;
  queries[5].tolerance = 0;
  queries[6].speed = nan;

  for (const FlyableQuery& query : queries) {
    const auto way = make_flyable(query, a_blimp());
    ASSERT_FALSE(way.has_value());
    EXPECT_EQ(way.error().kind, RefusalKind::kBadQuery);
  }
  world::VehicleModel vehicle = a_blimp();
  vehicle.min_turn_radius = 0;
  EXPECT_FALSE(make_flyable(query_of(good), vehicle).has_value());
  EXPECT_FALSE(is_flyable(good, vehicle, 0, kTolerance));
}

/// A ridge across the way, 100 m high, and what it leaves free.
double floor_over_ridge(const Vector2& at) {
  return std::max(0.0, 100 - std::abs(at.x() - 500) / 2) + 5;
}
bool is_over_ridge(const Vector3& a, const Vector3& b) {
  for (int i = 0; i <= 20; ++i) {
    const Vector3 at = a + (b - a) * i / 20;
    if (at.z() < floor_over_ridge(at.head<2>()) - 5) return false;
  }
  return true;
}

TEST(Lowered, AWayOverARidgeClimbsNoHigherThanItHasTo) {
  Random random(8);
  for (int i = 0; i < 20; ++i) {
    FlyableQuery query = query_of({{0, 0, 30}, {500, 0, random.uniform(160, 300)}, {1000, 0, 30}});
    query.is_free = is_over_ridge;
    query.heading_from = random.uniform(-kPi, kPi);
    const auto high = make_flyable(query, a_blimp());
    ASSERT_TRUE(high.has_value());

    const Way low = lowered(*high, query, a_blimp(), floor_over_ridge);

    expect_flyable(low, a_blimp());
    for (std::size_t k = 1; k < low.size(); ++k) EXPECT_TRUE(is_over_ridge(low[k - 1], low[k]));
    EXPECT_EQ(low.front(), high->front());
    EXPECT_EQ(low.back(), high->back());
    EXPECT_NEAR(world::wrapped(heading_of(low[0], low[1]) - *query.heading_from), 0, 0.3);
    EXPECT_LE(level_length(low), std::min(level_length(*high), 1200.0));
  }
}

TEST(Lowered, AWayThatNothingCouldShortenStaysAsItIs) {
  FlyableQuery query = query_of({{0, 0, 50}, {400, 0, 50}});
  const auto way = make_flyable(query, a_blimp());
  ASSERT_TRUE(way.has_value());

  const Way low = lowered(*way, query, a_blimp(), [](const Vector2&) { return 0.0; });

  EXPECT_EQ(low, *way);
}

TEST(Lowered, NothingIsChangedOnceTheTimeIsUp) {
  FlyableQuery query = query_of({{0, 0, 30}, {500, 0, 250}, {1000, 0, 30}});
  const auto way = make_flyable(query, a_blimp());
  ASSERT_TRUE(way.has_value());
  query.time_is_up = [] { return true; };

  const Way low = lowered(*way, query, a_blimp(), [](const Vector2&) { return 0.0; });

  EXPECT_EQ(low, *way);
}

TEST(IsFlyable, SharpCornersAndSteepLegsAreNot) {
  const auto vehicle = a_blimp();

  EXPECT_TRUE(is_flyable({{0, 0, 50}, {100, 0, 50}}, vehicle, 0, kTolerance));
  EXPECT_FALSE(is_flyable({{0, 0, 50}, {100, 0, 50}, {100, 100, 50}}, vehicle, 0, kTolerance));
  EXPECT_FALSE(is_flyable({{0, 0, 50}, {100, 0, 50}, {0, 0, 50}}, vehicle, 0, kTolerance));
  EXPECT_FALSE(is_flyable({{0, 0, 50}, {100, 0, 70}}, vehicle, 0, kTolerance));
  EXPECT_FALSE(is_flyable({{0, 0, 50}, {100, 0, 34}}, vehicle, 0, kTolerance));
  EXPECT_FALSE(is_flyable({{0, 0, 50}, {0, 0, 51}}, vehicle, 0, kTolerance));
  EXPECT_TRUE(is_flyable({{0, 0, 50}, {100, 0, 70}}, vehicle, 4, kTolerance))
      << "slower is steeper";
}

TEST(IsFlyable, ACircleTooTightIsNotHoweverFineItsSamples) {
  const auto vehicle = a_blimp();
  for (const double radius : {20.0, 24.5, 25.0, 40.0})
    for (const double sampled : {0.01, 0.1, 0.5}) {
      Way way;
      for (const Vector2& at : DubinsCurve::circle({{0, 0}, 0}, radius, true).sampled(sampled))
        way.emplace_back(at.x(), at.y(), 50);

      EXPECT_EQ(is_flyable(way, vehicle, 0, kTolerance), radius >= 25) << radius << " " << sampled;
    }
}

TEST(Flyable, RandomCornersInFreeAirAlwaysGiveAFlyableWay) {
  Random random(5);
  for (int i = 0; i < 400; ++i) {
    FlyableQuery query = query_of({});
    const std::uint64_t count = 2 + random.below(7);
    const double extent = random.uniform(50, 1500);
    for (std::uint64_t k = 0; k < count; ++k)
      query.corners.emplace_back(random.uniform(0, extent), random.uniform(0, extent),
                                 random.uniform(20, 190));
    if (random.chance(0.5)) query.heading_from = random.uniform(-kPi, kPi);
    if (random.chance(0.5)) query.heading_to = random.uniform(-kPi, kPi);

    const auto way = make_flyable(query, a_blimp());

    ASSERT_TRUE(way.has_value()) << way.error().why;
    expect_flyable(*way, a_blimp());
    EXPECT_EQ(way->front(), query.corners.front());
    EXPECT_EQ(way->back(), query.corners.back());
    EXPECT_EQ(*make_flyable(query, a_blimp()), *way) << "the same answer twice";
  }
}

Clutter random_clutter(Random& random) {
  Clutter clutter;
  for (int i = 0; i < 60; ++i)
    clutter.balls.push_back(
        {{random.uniform(0, 1000), random.uniform(0, 1000), random.uniform(0, 200)},
         random.uniform(10, 60)});
  return clutter;
}

/// A way of free legs, each straight on from the last as far as chance has it.
Way random_free_way(Random& random, const Clutter& clutter) {
  Way way;
  for (int tries = 0; tries < 5000 && way.size() < 6; ++tries) {
    const Vector3 next(random.uniform(0, 1000), random.uniform(0, 1000), random.uniform(20, 190));
    if (clutter.is_free(way.empty() ? next : way.back(), next)) way.push_back(next);
  }
  return way;
}

TEST(Flyable, WaysAmongObstaclesAreFreeAndMostAreFound) {
  Random random(6);
  int found = 0;
  constexpr int kCases = 60;
  for (int i = 0; i < kCases; ++i) {
    const Clutter clutter = random_clutter(random);
    FlyableQuery query = query_of(random_free_way(random, clutter));
    query.is_free = [&](const Vector3& a, const Vector3& b) { return clutter.is_free(a, b); };

    const auto way = make_flyable(query, a_blimp());

    if (!way) {
      EXPECT_EQ(way.error().kind, RefusalKind::kBeyondVehicle);
      continue;
    }
    ++found;
    expect_flyable(*way, a_blimp());
    expect_clear(*way, clutter);
  }
  RecordProperty("found", found);
  EXPECT_GE(found, kCases * 9 / 10);
}

}  // namespace
}  // namespace skein::refiners
