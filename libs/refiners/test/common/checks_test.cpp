// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "skein/world/polygon_check.hpp"
#include "testing/builders.hpp"

namespace skein::refiners {
namespace {

using testing::fixed_wing;
using ::testing::HasSubstr;
using testing::helicopter;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const world::Polygon kSquare = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};

TEST(Checks, FinitePointsPass) { EXPECT_FALSE(check_finite({1, 2, 3}, "to")); }

TEST(Checks, APointThatIsNotANumberIsABadQueryThatNamesTheField) {
  const auto refusal = check_finite({1, kNaN, 3}, "to");

  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->kind, RefusalKind::kBadQuery);
  EXPECT_EQ(refusal->field, "to");
}

TEST(Checks, OnlyFiniteFiguresAboveZeroArePositive) {
  EXPECT_FALSE(check_positive(1e-9, "swath"));
  EXPECT_TRUE(check_positive(0, "swath"));
  EXPECT_TRUE(check_positive(-3, "swath"));
  EXPECT_TRUE(check_positive(kNaN, "swath"));
  EXPECT_TRUE(check_positive(std::numeric_limits<double>::infinity(), "swath"));
}

TEST(Checks, TheVehiclesOfTheTestsPass) {
  EXPECT_FALSE(check_vehicle(helicopter()));
  EXPECT_FALSE(check_vehicle(fixed_wing()));
}

TEST(Checks, AVehicleThatCannotMoveIsRefusedByTheFigureThatStopsIt) {
  world::VehicleModel still = helicopter();
  still.cruise_speed = 0;
  world::VehicleModel sinking = helicopter();
  sinking.descent_rate = -1;
  world::VehicleModel straight = fixed_wing();
  straight.min_turn_radius = 0;

  EXPECT_EQ(check_vehicle(still)->field, "vehicle.speed.cruise");
  EXPECT_EQ(check_vehicle(sinking)->field, "vehicle.descent_rate");
  EXPECT_EQ(check_vehicle(straight)->field, "vehicle.min_turn_radius");
}

TEST(Checks, SpeedsThatContradictEachOtherAreRefused) {
  world::VehicleModel vehicle = fixed_wing();
  vehicle.cruise_speed = 30;
  EXPECT_THAT(check_vehicle(vehicle)->why, HasSubstr("more than max"));

  vehicle = fixed_wing();
  vehicle.min_speed = 20;
  EXPECT_EQ(check_vehicle(vehicle)->field, "vehicle.speed.min");
}

TEST(Checks, SimplePolygonsPassInEitherSense) {
  world::Polygon clockwise(kSquare.rbegin(), kSquare.rend());
  const world::Polygon notched = {{0, 0}, {10, 0}, {10, 10}, {5, 4}, {0, 10}};

  EXPECT_FALSE(check_polygon(kSquare, "area"));
  EXPECT_FALSE(check_polygon(clockwise, "area"));
  EXPECT_FALSE(check_polygon(notched, "area"));
}

TEST(Checks, TwoCornersAreNoArea) {
  EXPECT_THAT(check_polygon({{0, 0}, {1, 1}}, "area")->why, HasSubstr("at least three"));
}

TEST(Checks, CornersOnOneLineAreNoArea) {
  EXPECT_TRUE(check_polygon({{0, 0}, {1, 1}, {2, 2}}, "area"));
}

TEST(Checks, APolygonThatCrossesItselfIsRefusedByItsEdges) {
  const auto refusal = check_polygon({{0, 0}, {10, 10}, {10, 0}, {0, 10}}, "zone");

  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->field, "zone");
  EXPECT_THAT(refusal->why, HasSubstr("corner 1 and corner 3 cross"));
}

TEST(Checks, ACornerOnAnotherEdgeIsRefused) {
  EXPECT_TRUE(check_polygon({{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}}, "zone"));
}

TEST(Checks, ARepeatedCornerIsRefused) {
  EXPECT_THAT(check_polygon({{0, 0}, {10, 0}, {10, 0}, {0, 10}}, "zone")->why,
              HasSubstr("corner 2 and corner 3 are the same place"));
}

TEST(Checks, ABorderThatFoldsBackIsRefused) {
  EXPECT_THAT(check_polygon({{0, 0}, {10, 0}, {5, 0}, {5, 8}}, "zone")->why,
              HasSubstr("folds back"));
}

TEST(Checks, ACornerThatIsNotANumberIsRefusedByItsPlace) {
  EXPECT_EQ(check_polygon({{0, 0}, {kNaN, 0}, {5, 5}}, "zone")->field, "zone.1");
}

TEST(Checks, MoreCornersThanCanBeCheckedAreRefused) {
  world::Polygon circle;
  for (std::size_t i = 0; i <= world::kMostCorners; ++i) {
    const double angle = static_cast<double>(i) / 1000 * std::numbers::pi;
    circle.emplace_back(std::cos(angle), std::sin(angle));
  }
  EXPECT_THAT(check_polygon(circle, "zone")->why, HasSubstr("at most"));
}

TEST(Checks, AMissingSensorIsRefusedWithThoseThereAre) {
  world::VehicleModel vehicle = helicopter();
  vehicle.sensors.resize(2);
  vehicle.sensors[0].device = "visible";
  vehicle.sensors[1].device = "fire-sensor";

  EXPECT_EQ(*sensor_of(vehicle, "visible"), vehicle.sensors.data());
  const auto refusal = sensor_of(vehicle, "visibl");
  ASSERT_FALSE(refusal);
  EXPECT_EQ(refusal.error().kind, RefusalKind::kBeyondVehicle);
  EXPECT_THAT(refusal.error().why, HasSubstr("visible, fire-sensor"));
  EXPECT_THAT(refusal.error().why, HasSubstr("did you mean 'visible'"));
}

TEST(Refusal, EveryKindHasItsName) {
  EXPECT_EQ(to_text(RefusalKind::kBadQuery), "bad-query");
  EXPECT_EQ(to_text(RefusalKind::kBlocked), "blocked");
  EXPECT_EQ(to_text(RefusalKind::kUnreachable), "unreachable");
  EXPECT_EQ(to_text(RefusalKind::kBeyondVehicle), "beyond-vehicle");
  EXPECT_EQ(to_text(RefusalKind::kNoContact), "no-contact");
  EXPECT_EQ(to_text(RefusalKind::kNotPerceivable), "not-perceivable");
  EXPECT_EQ(to_text(RefusalKind::kBudgetExhausted), "budget-exhausted");
}

TEST(Countdown, EndsAtTheStepsOfTheBudgetWithoutAskingTheClock) {
  const Budget budget{.time_is_up = nullptr, .steps = 3};
  Countdown countdown(budget);

  EXPECT_TRUE(countdown.step() && countdown.step() && countdown.step());
  EXPECT_FALSE(countdown.step());
  EXPECT_TRUE(countdown.over());
  EXPECT_FALSE(countdown.cut_short());
}

TEST(Countdown, AsksTheClockOnceAStride) {
  int asked = 0;
  const Budget budget{.time_is_up = [&] { return ++asked == 2; }};
  Countdown countdown(budget, 10);

  int steps = 0;
  while (countdown.step()) ++steps;

  EXPECT_EQ(asked, 2);
  EXPECT_EQ(steps, 19);
  EXPECT_TRUE(countdown.cut_short());
}

}  // namespace
}  // namespace skein::refiners
