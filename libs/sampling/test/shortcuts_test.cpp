// SPDX-License-Identifier: Apache-2.0
#include "shortcuts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "worlds.hpp"

namespace skein::sampling {
namespace {

using refiners::Way;
using world::Vector3;

const auto kNever = [] { return false; };

Way zigzag(Random& random) {
  Way way;
  for (int i = 0; i < 30; ++i)
    way.emplace_back(10 * i, random.uniform(-50, 50), random.uniform(20, 80));
  return way;
}

TEST(Shortened, IsStraightWhereEverythingIsFree) {
  Random random(1);
  const Way way = zigzag(random);

  const Way best = shortened(
      way, [](const Vector3&, const Vector3&) { return true; }, kNever, random);

  EXPECT_EQ(best, (Way{way.front(), way.back()}));
}

TEST(Shortened, NeverUsesALegThatIsNotFreeAndIsNeverLonger) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const Way way = zigzag(random);
    // Only what stays within 60 m of the axis x and rises less than 40 m is free, or as it was.
    const auto is_free = [&](const Vector3& a, const Vector3& b) {
      for (std::size_t k = 1; k < way.size(); ++k)
        if (a == way[k - 1] && b == way[k]) return true;
      return (b - a).norm() < 60 && std::abs(b.z() - a.z()) < 40;
    };

    const Way best = shortened(way, is_free, kNever, random);

    EXPECT_EQ(best.front(), way.front());
    EXPECT_EQ(best.back(), way.back());
    EXPECT_LE(refiners::length_of(best), refiners::length_of(way) + 1e-9);
    EXPECT_LT(refiners::length_of(best), 0.6 * refiners::length_of(way));
  }
}

TEST(Shortened, EveryLegIsOneThatWasAskedForAndFreeOrGiven) {
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const Way way = zigzag(random);
    using Leg = std::pair<std::array<double, 3>, std::array<double, 3>>;
    const auto leg_of = [](const Vector3& a, const Vector3& b) {
      return Leg{{a.x(), a.y(), a.z()}, {b.x(), b.y(), b.z()}};
    };
    std::set<Leg> free;
    for (std::size_t k = 1; k < way.size(); ++k) free.insert(leg_of(way[k - 1], way[k]));
    // As samples may have it: free or not for no reason, so that parts of free legs need not be.
    const auto is_free = [&](const Vector3& a, const Vector3& b) {
      const double dice = std::sin(a.x() * 12.9 + a.z() * 4.1 + b.y() * 78.2 + b.z() * 37.7) * 1e4;
      const bool is = free.contains(leg_of(a, b)) || dice - std::floor(dice) < 0.3;
      if (is) free.insert(leg_of(a, b));
      return is;
    };

    const Way best = shortened(way, is_free, kNever, random);

    ASSERT_LT(refiners::length_of(best), refiners::length_of(way));
    for (std::size_t k = 1; k < best.size(); ++k)
      EXPECT_TRUE(free.contains(leg_of(best[k - 1], best[k]))) << "leg " << k;
  }
}

TEST(Shortened, IsTautAboutACylinder) {
  const double radius = 10, half = 50;
  // Every line across it, by the distance from its axis, which is vertical.
  const auto is_free = [&](const Vector3& a, const Vector3& b) {
    const world::Vector2 from = a.head<2>(), step = (b - a).head<2>();
    const double t =
        step.squaredNorm() > 0 ? std::clamp(-from.dot(step) / step.squaredNorm(), 0.0, 1.0) : 0;
    return (from + t * step).norm() >= radius;
  };
  const double taut =
      2 * std::sqrt(half * half - radius * radius) + radius * 2 * std::asin(radius / half);
  const Way way = {{-half, 0, 0}, {-40, 30, 20}, {-10, 60, -30}, {30, 45, 40}, {half, 0, 0}};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);

    const Way best = shortened(way, is_free, kNever, random);

    EXPECT_GE(refiners::length_of(best), taut);
    EXPECT_LE(refiners::length_of(best), 1.005 * taut) << "seed " << seed;
  }
}

TEST(Shortened, LeavesAWayOfTwoPointsAlone) {
  Random random(3);
  const Way way = {{0, 0, 0}, {1, 1, 1}};

  EXPECT_EQ(shortened(
                way, [](const Vector3&, const Vector3&) { return false; }, kNever, random),
            way);
}

}  // namespace
}  // namespace skein::sampling
