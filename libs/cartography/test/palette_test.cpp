// SPDX-License-Identifier: Apache-2.0
#include "palette.hpp"

#include <gtest/gtest.h>

#include <set>

namespace skein::cartography {
namespace {

double lightness(Colour colour) {
  return 0.2126 * colour.red + 0.7152 * colour.green + 0.0722 * colour.blue;
}

TEST(Palette, HeatGetsLighterAllTheWayUp) {
  for (int i = 1; i <= 50; ++i)
    EXPECT_GE(lightness(heat_tint(i / 50.0)), lightness(heat_tint((i - 1) / 50.0))) << i;
}

TEST(Palette, WhatIsBeyondTheScaleHasTheColourOfItsEnd) {
  EXPECT_EQ(heat_tint(-3), heat_tint(0));
  EXPECT_EQ(heat_tint(7), heat_tint(1));
}

TEST(Palette, GroundInTheShadeIsDarker) {
  EXPECT_LT(lightness(ground_tint(0.5, 0.1)), lightness(ground_tint(0.5, 0.7)));
}

TEST(Palette, EightLinesCanBeToldApart) {
  std::set<std::string> colours;
  for (std::size_t i = 0; i < 8; ++i) colours.insert(line_colour(i));

  EXPECT_EQ(colours.size(), 8U);
  EXPECT_EQ(line_colour(9), line_colour(1));
}

TEST(Palette, ColoursAreWrittenAsTheWebHasThem) { EXPECT_EQ(hex({255, 1, 16}), "#ff0110"); }

}  // namespace
}  // namespace skein::cartography
