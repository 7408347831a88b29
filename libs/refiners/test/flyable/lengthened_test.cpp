// SPDX-License-Identifier: Apache-2.0
#include "flyable/lengthened.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "skein/foundation/random.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
constexpr double kHalfTurn = std::numbers::pi;
constexpr double kTolerance = 0.5, kRadius = 30;

struct Asked {
  Pose from, to;
  AddedTurn turn;
  double least;
};

/// Poses at least four radii apart, between which each length can be flown, and any turn there.
Asked random_asked(Random& random) {
  constexpr double kPlaces[] = {0, 0.25, 0.5, 0.75, 1};
  const double along = random.uniform(-kHalfTurn, kHalfTurn), apart = random.uniform(150, 600);
  Asked asked;
  asked.from = {{random.uniform(-200, 200), random.uniform(-200, 200)},
                random.uniform(-kHalfTurn, kHalfTurn)};
  asked.to = {asked.from.at + apart * Vector2(std::cos(along), std::sin(along)),
              random.uniform(-kHalfTurn, kHalfTurn)};
  asked.turn = {kPlaces[random.below(5)], random.chance(0.5), random.chance(0.5)};
  const double shortest = DubinsCurve::shortest(asked.from, asked.to, kRadius).length();
  asked.least = shortest * random.uniform(0.5, 4);
  return asked;
}

LevelWay lengthened(const Asked& asked) {
  return lengthened(asked.from, asked.to, kRadius, asked.turn, asked.least, kTolerance);
}

TEST(Lengthened, IsAsLongAsAskedBetweenTheSamePoses) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Asked asked = random_asked(random);

    const LevelWay way = lengthened(asked);

    EXPECT_GE(length_of(way), asked.least - 1e-6) << "case " << i;
    EXPECT_LT((way.front() - asked.from.at).norm(), 1e-9);
    EXPECT_LT((way.back() - asked.to.at).norm(), 1e-9);
  }
}

/// Whole circles would be up to 188 m longer; one way round and one place may have a gap.
TEST(Lengthened, IsNoLongerThanAskedOneWayRoundOrTheOtherAtTheFirstOrLastPlace) {
  Random random(2);
  int longer = 0;
  constexpr int kCases = 1000;
  for (int i = 0; i < kCases; ++i) {
    Asked asked = random_asked(random);
    const auto shortest = DubinsCurve::shortest(asked.from, asked.to, kRadius);
    const double enough = std::max(asked.least, shortest.length());
    double least = std::numeric_limits<double>::infinity();
    for (const bool left : {true, false})
      for (const bool at_the_end : {true, false}) {
        asked.turn = {at_the_end ? 1.0 : 0.0, left, at_the_end};
        least = std::min(least, length_of(lengthened(asked)));
      }
    EXPECT_LE(least, enough + 2 * kHalfTurn * kRadius + 1) << "case " << i;
    if (least > enough + 0.15 * kRadius) ++longer;
  }
  EXPECT_LE(longer, kCases / 50);
}

TEST(Lengthened, TurnsNoTighterThanTheRadius) {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const LevelWay way = without_doubles(lengthened(random_asked(random)), 1e-6 * kRadius);

    for (std::size_t k = 1; k + 1 < way.size(); ++k) {
      const Vector2 in = way[k] - way[k - 1], out = way[k + 1] - way[k];
      const double turn = std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out)));
      const auto half = [](double chord) {
        return std::min(chord_angle(kRadius, kTolerance) / 2,
                        std::asin(std::min(1.0, chord / (2 * kRadius))));
      };
      EXPECT_LE(turn, half(in.norm()) + half(out.norm()) + 1e-5) << "case " << i << ", " << k;
    }
  }
}

}  // namespace
}  // namespace skein::refiners
