// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/flight.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "skein/foundation/random.hpp"
#include "testing/builders.hpp"

namespace skein::refiners {
namespace {

using testing::fixed_wing;
using testing::helicopter;
using world::Vector3;
using world::Wind;

TEST(Flight, LevelWayInStillAirTakesItsLengthOverTheCruiseSpeed) {
  const Flight flight = estimate_flight({{0, 0, 50}, {300, 400, 50}}, helicopter(), {});

  EXPECT_DOUBLE_EQ(flight.length, 500);
  EXPECT_DOUBLE_EQ(flight.duration.expected.to_seconds(), 50);
  EXPECT_DOUBLE_EQ(flight.duration.most.to_seconds(), 50);
  EXPECT_NEAR(flight.duration.least.to_seconds(), 500.0 / 15, 1e-6);
}

TEST(Flight, SteepLegTakesAsLongAsItsClimb) {
  const Flight up = estimate_flight({{0, 0, 0}, {10, 0, 80}}, helicopter(), {});
  const Flight down = estimate_flight({{10, 0, 80}, {0, 0, 5}}, helicopter(), {});

  EXPECT_DOUBLE_EQ(up.duration.expected.to_seconds(), 20);
  EXPECT_DOUBLE_EQ(up.duration.least.to_seconds(), 20);
  EXPECT_DOUBLE_EQ(down.duration.expected.to_seconds(), 25);
}

TEST(Flight, SpeedAskedForReplacesTheCruiseSpeed) {
  const Flight flight = estimate_flight({{0, 0, 50}, {100, 0, 50}}, helicopter(), {}, 5);

  EXPECT_DOUBLE_EQ(flight.duration.expected.to_seconds(), 20);
}

TEST(Flight, WindCountsAsFarAsTheVehicleDrifts) {
  world::VehicleModel vehicle = helicopter();
  const Wind east_wind{.toward = 0, .speed = 4, .gusts = 1};
  const Way east = {{0, 0, 50}, {300, 0, 50}};

  vehicle.wind_drift = 0;
  const double still = estimate_flight(east, vehicle, east_wind).duration.expected.to_seconds();
  vehicle.wind_drift = 0.5;
  const DurationInterval drifting = estimate_flight(east, vehicle, east_wind).duration;

  EXPECT_DOUBLE_EQ(still, 30);
  EXPECT_DOUBLE_EQ(drifting.expected.to_seconds(), 300.0 / 12);
  EXPECT_NEAR(drifting.most.to_seconds(), 300.0 / 7.5, 1e-6);
  EXPECT_NEAR(drifting.least.to_seconds(), 300.0 / 17.5, 1e-6);
}

TEST(Flight, CrossWindIsHeldByFlyingIntoIt) {
  world::VehicleModel vehicle = helicopter();
  vehicle.wind_drift = 1;
  const Wind north_wind{.toward = std::numbers::pi / 2, .speed = 6, .gusts = 0};

  const Flight flight = estimate_flight({{0, 0, 50}, {80, 0, 50}}, vehicle, north_wind);

  EXPECT_NEAR(flight.duration.expected.to_seconds(), 10, 1e-9);  // √(10² - 6²) = 8 m/s
}

TEST(Flight, WindAsFastAsTheVehicleHoldsItForEver) {
  world::VehicleModel vehicle = helicopter();
  vehicle.wind_drift = 1;
  const Wind storm{.toward = std::numbers::pi, .speed = 10, .gusts = 0};

  const Flight flight = estimate_flight({{0, 0, 50}, {80, 0, 50}}, vehicle, storm);

  EXPECT_EQ(flight.duration.expected, Duration::max());
  EXPECT_EQ(flight.duration.most, Duration::max());
}

TEST(Flight, EnergyOfALevelWayIsPowerByTime) {
  const Flight flight = estimate_flight({{0, 0, 50}, {1000, 0, 50}}, helicopter(), {});

  EXPECT_NEAR(flight.energy, 100 * 1200 / 5e6, 1e-12);
}

TEST(Flight, ClimbingOnTheSpotDrawsHoverAndClimbPower) {
  const Flight flight = estimate_flight({{0, 0, 0}, {0, 0, 40}}, helicopter(), {});

  EXPECT_NEAR(flight.energy, 10 * (1000 + 500) / 5e6, 1e-12);
}

TEST(Flight, OnePointTakesNothing) {
  const Flight flight = estimate_flight({{1, 2, 3}}, fixed_wing(), {});

  EXPECT_EQ(flight.duration, DurationInterval());
  EXPECT_EQ(flight.length, 0);
}

RC_GTEST_PROP(Flight, LeastExpectedAndMostAreInOrder, (std::uint64_t seed)) {
  Random random(seed);
  Way way;
  for (int i = 0; i < 6; ++i)
    way.emplace_back(random.uniform(-900, 900), random.uniform(-900, 900), random.uniform(0, 200));
  world::VehicleModel vehicle = random.chance(0.5) ? helicopter() : fixed_wing();
  vehicle.wind_drift = random.uniform();
  const Wind wind{random.uniform(-3, 3), random.uniform(0, 12), random.uniform(0, 3)};

  const Flight flight = estimate_flight(way, vehicle, wind);

  RC_ASSERT(flight.duration.least <= flight.duration.expected);
  RC_ASSERT(flight.duration.expected <= flight.duration.most);
  RC_ASSERT(std::abs(flight.length - length_of(way)) < 1e-9);
}

RC_GTEST_PROP(Flight, CuttingALegInTwoChangesNothing, (std::uint64_t seed)) {
  Random random(seed);
  const Vector3 a(random.uniform(-900, 900), random.uniform(-900, 900), random.uniform(0, 200));
  const Vector3 b(random.uniform(-900, 900), random.uniform(-900, 900), random.uniform(0, 200));
  world::VehicleModel vehicle = helicopter();
  vehicle.wind_drift = 0.5;
  const Wind wind{random.uniform(-3, 3), random.uniform(0, 9), 0};

  const Flight whole = estimate_flight({a, b}, vehicle, wind);
  const Flight cut = estimate_flight({a, a + random.uniform() * (b - a), b}, vehicle, wind);

  const double seconds = whole.duration.expected.to_seconds();
  RC_ASSERT(std::abs(seconds - cut.duration.expected.to_seconds()) < 1e-6);
  RC_ASSERT(std::abs(whole.energy - cut.energy) < 1e-9);
}

}  // namespace
}  // namespace skein::refiners
