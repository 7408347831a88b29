// SPDX-License-Identifier: Apache-2.0
#include "gusts.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace skein::sim {
namespace {

TEST(Gusts, WithoutGustsTheWindIsItsMean) {
  Gusts gusts({0.6, 2, 0}, Random(1));

  for (int i = 0; i < 5; ++i) EXPECT_EQ(gusts.next(0.1), world::mean_velocity({0.6, 2, 0}));
}

TEST(Gusts, HaveTheMeanAndTheDeviationOfTheWind) {
  const world::Wind wind{0.6, 2, 0.5};
  Gusts gusts(wind, Random(1));
  const int n = 400000;

  world::Vector3 sum = world::Vector3::Zero(), squares = world::Vector3::Zero();
  for (int i = 0; i < n; ++i) {
    const world::Vector3 gust = gusts.next(0.1) - world::mean_velocity(wind);
    sum += gust;
    squares += gust.cwiseProduct(gust);
  }

  EXPECT_NEAR(sum.x() / n, 0, 0.03);
  EXPECT_NEAR(sum.y() / n, 0, 0.03);
  EXPECT_NEAR(std::sqrt(squares.x() / n), 0.5, 0.03);
  EXPECT_NEAR(std::sqrt(squares.y() / n), 0.5, 0.03);
  EXPECT_EQ(squares.z(), 0);
}

TEST(Gusts, ChangeSlowly) {
  Gusts gusts({0, 0, 1}, Random(2));
  world::Vector3 before = gusts.next(0.1);

  double mean_change = 0;
  for (int i = 0; i < 10000; ++i) {
    const world::Vector3 now = gusts.next(0.1);
    mean_change += (now - before).norm() / 10000;
    before = now;
  }

  EXPECT_LT(mean_change, 0.4);
}

}  // namespace
}  // namespace skein::sim
