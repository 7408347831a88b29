// SPDX-License-Identifier: Apache-2.0
#include "partition/shares.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace skein::refiners::partition {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

double sum(const std::vector<double>& areas) {
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

TEST(FairAreas, AreInProportionOfTheRatesWhenAllAreReady) {
  const auto areas = fair_areas({{1, 0, kNoLimit}, {2, 0, kNoLimit}, {5, 0, kNoLimit}}, 800);

  ASSERT_TRUE(areas);
  EXPECT_NEAR((*areas)[0], 100, 1e-9);
  EXPECT_NEAR((*areas)[1], 200, 1e-9);
  EXPECT_NEAR((*areas)[2], 500, 1e-9);
}

TEST(FairAreas, MakeThoseWhoComeLateEndWithTheOthers) {
  const auto areas = fair_areas({{2, 0, kNoLimit}, {2, 50, kNoLimit}}, 300);

  ASSERT_TRUE(areas);
  EXPECT_NEAR((*areas)[0], 200, 1e-9);
  EXPECT_NEAR((*areas)[1], 100, 1e-9);
}

TEST(FairAreas, LeaveToTheOthersWhatOneHasNoEnergyFor) {
  const auto areas = fair_areas({{1, 0, 30}, {1, 0, kNoLimit}, {2, 0, kNoLimit}}, 400);

  ASSERT_TRUE(areas);
  EXPECT_NEAR((*areas)[0], 30, 1e-9);
  EXPECT_NEAR((*areas)[1], 370.0 / 3, 1e-9);
  EXPECT_NEAR(sum(*areas), 400, 1e-9);
}

TEST(FairAreas, LeaveAPartEvenToWhoComesAfterAllIsDone) {
  const auto areas = fair_areas({{1, 0, kNoLimit}, {1, 1e9, kNoLimit}}, 100);

  ASSERT_TRUE(areas);
  EXPECT_GT((*areas)[1], 0.4);
  EXPECT_LT((*areas)[1], 1);
  EXPECT_NEAR(sum(*areas), 100, 1e-9);
}

TEST(FairAreas, AreNoneWhenAllTogetherLackTheEnergy) {
  EXPECT_FALSE(fair_areas({{1, 0, 30}, {1, 0, 60}}, 100));
  EXPECT_TRUE(fair_areas({{1, 0, 40}, {1, 0, 60}}, 100));
}

}  // namespace
}  // namespace skein::refiners::partition
