// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "skein/auction/aim.hpp"

namespace skein::auction {
namespace {

TEST(Objective, WithoutEquityItIsTheSumAndTheMakespanBreaksTies) {
  const Value value = value_of(Aim{0}, 2, 30, 7);

  EXPECT_EQ(value.unsold, 2U);
  EXPECT_EQ(value.first, 30);
  EXPECT_EQ(value.second, 7);
}

TEST(Objective, WithFullEquityItIsTheMakespanAndTheSumBreaksTies) {
  const Value value = value_of(Aim{1}, 0, 30, 7);

  EXPECT_EQ(value.first, 7);
  EXPECT_EQ(value.second, 30);
}

TEST(Objective, FromHalfEquityOnTheSumBreaksTies) {
  EXPECT_EQ(value_of(Aim{0.5}, 0, 30, 10).first, 20);
  EXPECT_EQ(value_of(Aim{0.5}, 0, 30, 10).second, 30);
  EXPECT_EQ(value_of(Aim{0.49}, 0, 30, 10).second, 10);
}

TEST(Objective, ATaskMoreSoldIsWorthAnyCost) {
  EXPECT_TRUE(better({0, 1e9, 1e9}, {1, 0, 0}));
  EXPECT_FALSE(better({1, 0, 0}, {0, 1e9, 1e9}));
}

TEST(Objective, LessThanAMillionthIsARoundingErrorAndNoGain) {
  EXPECT_TRUE(better({0, 1 - 2e-6, 5}, {0, 1, 5}));
  EXPECT_FALSE(better({0, 1 - 0.5e-6, 5}, {0, 1, 5}));
  EXPECT_FALSE(better({0, 1, 5}, {0, 1, 5})) << "nothing is better than itself";
}

TEST(Objective, TheTieBreakerCountsOnlyWhereTheAimIsEqual) {
  EXPECT_TRUE(better({0, 1, 4}, {0, 1, 5}));
  EXPECT_FALSE(better({0, 1 + 2e-6, 4}, {0, 1, 5}));
  EXPECT_FALSE(better({0, 1, 5 - 0.5e-6}, {0, 1, 5}));
}

TEST(Objective, EarlierEndsCountOnlyWhereAimAndTieBreakerAreEqual) {
  EXPECT_TRUE(better({0, 1, 5, 8}, {0, 1, 5, 9}));
  EXPECT_FALSE(better({0, 1, 5, 9}, {0, 1, 5, 8}));
  EXPECT_FALSE(better({0, 1, 5 + 2e-6, 8}, {0, 1, 5, 9}));
  EXPECT_FALSE(better({0, 1, 5, 9 - 0.5e-6}, {0, 1, 5, 9}));
}

}  // namespace
}  // namespace skein::auction
