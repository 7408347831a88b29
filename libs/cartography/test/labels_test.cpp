// SPDX-License-Identifier: Apache-2.0
#include "labels.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace skein::cartography {
namespace {

/// Where the middle of each text came to stand.
std::vector<Spot> spots_of(const std::string& svg) {
  std::vector<Spot> spots;
  const std::regex place(R"(<text x="([-0-9.]+)\" y="([-0-9.]+)\")");
  for (std::sregex_iterator i(svg.begin(), svg.end(), place), end; i != end; ++i)
    spots.push_back({std::stod((*i)[1]), std::stod((*i)[2])});
  return spots;
}

TEST(Labels, StandToTheRightOfTheirDot) {
  const auto spots = spots_of(placed({{{100, 100}, "name"}}, 400, 400));

  ASSERT_EQ(spots.size(), 1U);
  EXPECT_GT(spots[0].x, 105);
  EXPECT_NEAR(spots[0].y, 100, 6);
}

TEST(Labels, OfTheSamePlaceDoNotCoverEachOther) {
  const auto spots = spots_of(placed({{{100, 100}, "first"}, {{100, 100}, "second"}}, 400, 400));

  ASSERT_EQ(spots.size(), 2U);
  const bool apart =
      std::abs(spots[0].x - spots[1].x) > 30 || std::abs(spots[0].y - spots[1].y) > 11;
  EXPECT_TRUE(apart);
}

TEST(Labels, AtTheBorderStayInside) {
  const auto spots = spots_of(placed({{{398, 200}, "a long name"}}, 400, 400));

  EXPECT_LT(spots[0].x, 398);
}

TEST(Labels, OnTheSpotStandOnTheSpot) {
  const auto spots = spots_of(placed({{{50, 60}, "zone", "#000000", false}}, 400, 400));

  EXPECT_NEAR(spots[0].x, 50, 0.1);
  EXPECT_NEAR(spots[0].y, 60, 6);
}

TEST(SvgText, CountsCharactersNotBytes) { EXPECT_EQ(width_of("é×°", 10), width_of("abc", 10)); }

TEST(SvgText, HasNoNegativeZero) {
  EXPECT_EQ(px(-0.01), "0.0");
  EXPECT_EQ(px(1.25), "1.2");
}

}  // namespace
}  // namespace skein::cartography
