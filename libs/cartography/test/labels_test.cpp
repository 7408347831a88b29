// SPDX-License-Identifier: Apache-2.0
#include "labels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <regex>

#include "skein/foundation/random.hpp"

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

/// The boxes of drawn labels, as wide as their words.
std::vector<std::array<double, 4>> boxes_of(const std::vector<Label>& labels, double size) {
  std::vector<std::array<double, 4>> boxes;
  const auto spots = spots_of(placed(labels, size, size));
  for (std::size_t at = 0; at < labels.size(); ++at) {
    const double half = width_of(labels[at].words, 11) / 2;
    // The text stands on its base line, a third of its size below the middle of its box.
    const double middle = spots[at].y - 11 * 0.35;
    boxes.push_back({spots[at].x - half, middle - 6.5, spots[at].x + half, middle + 6.5});
  }
  return boxes;
}

TEST(Labels, FarFromEachOtherStayInsideAndOffAllDots) {
  Random random(6);
  for (int round = 0; round < 30; ++round) {
    std::vector<Label> labels;  // one in each field of 100 by 100, words of up to 60 pixels
    for (int field = 0; field < 16; ++field) {
      const double x = 100 * (field % 4) + random.uniform(1, 99);
      const double y = 100 * (field / 4) + random.uniform(30, 70);
      labels.push_back({{x, y}, std::string(1 + random.below(6), 'w')});
    }
    const auto boxes = boxes_of(labels, 400);
    for (const auto& [left, top, right, bottom] : boxes) {
      EXPECT_GE(left, -0.1);
      EXPECT_GE(top, -0.1);
      EXPECT_LE(right, 400.1);
      EXPECT_LE(bottom, 400.1);
      for (const Label& label : labels) {
        const bool covers =
            label.at.x > left && label.at.x < right && label.at.y > top && label.at.y < bottom;
        EXPECT_FALSE(covers) << label.at.x << " " << label.at.y;
      }
    }
    for (std::size_t one = 0; one < boxes.size(); ++one)
      for (std::size_t other = 0; other < one; ++other) {
        const bool apart =
            boxes[one][2] <= boxes[other][0] + 0.1 || boxes[other][2] <= boxes[one][0] + 0.1 ||
            boxes[one][3] <= boxes[other][1] + 0.1 || boxes[other][3] <= boxes[one][1] + 0.1;
        EXPECT_TRUE(apart) << "round " << round << ": " << one << " and " << other;
      }
  }
}

TEST(SvgText, CountsCharactersNotBytes) { EXPECT_EQ(width_of("é×°", 10), width_of("abc", 10)); }

TEST(SvgText, HasNoNegativeZero) {
  EXPECT_EQ(px(-0.01), "0.0");
  EXPECT_EQ(px(1.25), "1.2");
}

}  // namespace
}  // namespace skein::cartography
