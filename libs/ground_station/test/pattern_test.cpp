// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/pattern.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "skein/foundation/random.hpp"

namespace skein::ground_station {
namespace {

using world::Polygon;
using world::Vector2;

const Polygon kRectangle = {{0, 0}, {100, 0}, {100, 60}, {0, 60}};

double distance_to_segment(const Vector2& p, const Vector2& a, const Vector2& b) {
  const Vector2 way = b - a;
  const double length = way.squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(way) / length, 0.0, 1.0) : 0.0;
  return (p - a - t * way).norm();
}

// Only the legs count, not the ways between them.
double distance_to_legs(const Vector2& p, const std::vector<Vector2>& way) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < way.size(); i += 2) {
    least = std::min(least, distance_to_segment(p, way[i], way[i + 1]));
  }
  return least;
}

double distance_to_zone(const Vector2& p, const Polygon& zone) {
  if (world::contains(zone, p)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < zone.size(); ++i) {
    least = std::min(least, distance_to_segment(p, zone[i], zone[(i + 1) % zone.size()]));
  }
  return least;
}

// A star-shaped polygon about the origin: simple, convex or not.
Polygon star(Random& random, int corners) {
  Polygon zone;
  for (int i = 0; i < corners; ++i) {
    const double angle = (i + random.uniform(0.05, 0.95)) * 2 * std::numbers::pi / corners;
    const double radius = random.uniform(40, 300);
    zone.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return zone;
}

TEST(Boustrophedon, SweepsARectangleAlongItsLongSide) {
  const std::vector<Vector2> way = boustrophedon(kRectangle, 20);

  ASSERT_EQ(way.size(), 6U);
  EXPECT_TRUE(way[0].isApprox(Vector2(0, 10)));
  EXPECT_TRUE(way[1].isApprox(Vector2(100, 10)));
  EXPECT_TRUE(way[2].isApprox(Vector2(100, 30)));
  EXPECT_TRUE(way[3].isApprox(Vector2(0, 30)));
  EXPECT_TRUE(way[5].isApprox(Vector2(100, 50)));
}

TEST(Boustrophedon, EvensOutTheSpacingThatDoesNotDivideTheZone) {
  const std::vector<Vector2> way = boustrophedon(kRectangle, 25);

  ASSERT_EQ(way.size(), 6U);
  EXPECT_NEAR(way[2].y() - way[0].y(), 20, 1e-9);
}

TEST(Boustrophedon, OneLegDoesForAZoneNarrowerThanTheSpacing) {
  const std::vector<Vector2> way = boustrophedon(kRectangle, 500);

  ASSERT_EQ(way.size(), 2U);
  EXPECT_NEAR(way[0].y(), 30, 1e-9);
}

TEST(Boustrophedon, BeginsOnTheLegNearestToTheStart) {
  const std::vector<Vector2> way = boustrophedon(kRectangle, 10, Vector2(90, 44));

  EXPECT_TRUE(way.front().isApprox(Vector2(100, 45)));
  EXPECT_NEAR(way[2].y(), 55, 1e-9) << "the nearer side of the zone comes first";
  EXPECT_NEAR(way.back().y(), 5, 1e-9);
}

TEST(Boustrophedon, GivesNothingForWhatIsNoZone) {
  const double inf = std::numeric_limits<double>::infinity();

  EXPECT_TRUE(boustrophedon({}, 10).empty());
  EXPECT_TRUE(boustrophedon({{0, 0}, {10, 0}}, 10).empty());
  EXPECT_TRUE(boustrophedon({{0, 0}, {10, 0}, {20, 0}}, 10).empty());
  EXPECT_TRUE(boustrophedon({{0, 0}, {inf, 0}, {20, 20}}, 10).empty());
  EXPECT_TRUE(boustrophedon(kRectangle, 0).empty());
  EXPECT_TRUE(boustrophedon(kRectangle, -1).empty());
  EXPECT_TRUE(boustrophedon(kRectangle, std::nan("")).empty());
  EXPECT_TRUE(boustrophedon(kRectangle, 1e-6).empty()) << "too many legs";
}

TEST(Boustrophedon, EveryPointOfTheZoneIsWithinHalfASpacingOfALeg) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const Polygon zone = star(random, 3 + static_cast<int>(random.below(7)));
    const double spacing = random.uniform(5, 80);
    const bool has_start = random.chance(0.5);
    const Vector2 start(random.uniform(-300, 300), random.uniform(-300, 300));

    const std::vector<Vector2> way =
        boustrophedon(zone, spacing, has_start ? std::optional(start) : std::nullopt);

    for (int i = 0; i < 500; ++i) {
      const Vector2 sample(random.uniform(-300, 300), random.uniform(-300, 300));
      if (!world::contains(zone, sample)) continue;
      RC_ASSERT(distance_to_legs(sample, way) <= spacing / 2 + 1e-6);
    }
  }));
}

TEST(Boustrophedon, EveryPointOfALegIsWithinHalfASpacingOfTheZone) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const Polygon zone = star(random, 3 + static_cast<int>(random.below(7)));
    const double spacing = random.uniform(5, 80);

    const std::vector<Vector2> way = boustrophedon(zone, spacing);

    RC_ASSERT(way.size() % 2 == 0);
    for (std::size_t leg = 0; leg + 1 < way.size(); leg += 2) {
      for (int i = 0; i <= 20; ++i) {
        const Vector2 sample = way[leg] + i / 20.0 * (way[leg + 1] - way[leg]);
        RC_ASSERT(distance_to_zone(sample, zone) <= spacing / 2 + 1e-6);
      }
    }
  }));
}

TEST(Boustrophedon, DoesNotDependOnTheOrientationOfTheZone) {
  const Polygon reversed(kRectangle.rbegin(), kRectangle.rend());

  const std::vector<Vector2> way = boustrophedon(kRectangle, 20);
  const std::vector<Vector2> other = boustrophedon(reversed, 20);

  ASSERT_EQ(way.size(), other.size());
  for (const Vector2& point : other) {
    EXPECT_TRUE(std::any_of(way.begin(), way.end(),
                            [&](const Vector2& p) { return (p - point).norm() < 1e-9; }));
  }
}

}  // namespace
}  // namespace skein::ground_station
