// SPDX-License-Identifier: Apache-2.0
#include "map/relief.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace skein::report {
namespace {

// A cone of height 100 and radius 200 at (0, 0), on a grid from -300 to 300.
TerrainGrid cone() {
  TerrainGrid grid{-300, -300, 10, 61, 61, {}};
  for (std::size_t row = 0; row < grid.height; ++row) {
    for (std::size_t column = 0; column < grid.width; ++column) {
      const double x = -300 + 10.0 * static_cast<double>(column);
      const double y = -300 + 10.0 * static_cast<double>(row);
      grid.values.push_back(std::max(0.0, 100 - std::hypot(x, y) / 2));
    }
  }
  return grid;
}

using drawing::Colour;
using drawing::Pixels;

int brightness(const Pixels& image, std::size_t x, std::size_t y) {
  const Colour c = image.at(x, y);
  return c.red + c.green + c.blue;
}

TEST(Relief, TheSlopeTowardsTheNorthWestIsLit) {
  const Pixels image = shaded_relief(cone(), {-300, -300, 300, 300}, 60, 60);

  const int north_west = brightness(image, 22, 22);
  const int south_east = brightness(image, 37, 37);

  EXPECT_GT(north_west, south_east + 60);
}

TEST(Relief, HeightChoosesTheTint) {
  const Pixels image = shaded_relief(cone(), {-300, -300, 300, 300}, 60, 60);

  const auto green = [&](std::size_t x, std::size_t y) {  // of what is red there
    return static_cast<double>(image.at(x, y).green) / image.at(x, y).red;
  };
  EXPECT_NEAR(green(1, 1), 226.0 / 214, 0.02);
  EXPECT_NEAR(green(30, 30), 236.0 / 242, 0.02);
}

TEST(Relief, FlatGroundHasOneColour) {
  const TerrainGrid flat{0, 0, 1, 2, 2, {5, 5, 5, 5}};

  const Pixels image = shaded_relief(flat, {-10, -10, 10, 10}, 8, 8);

  for (std::size_t i = 0; i < 64; ++i) EXPECT_EQ(image.at(i % 8, i / 8), image.at(0, 0));
}

TEST(Relief, BeyondTheGridItsEdgeGoesOn) {
  const Pixels image = shaded_relief(cone(), {-3000, -3000, 3000, 3000}, 50, 50);

  EXPECT_EQ(image.width(), 50U);
  EXPECT_EQ(image.height(), 50U);
  EXPECT_EQ(image.at(0, 0), image.at(49, 49));
}

TEST(Relief, AGridThatDoesNotAddUpIsNotUsable) {
  EXPECT_FALSE(is_usable({0, 0, 1, 2, 2, {1, 2, 3}}));
  EXPECT_FALSE(is_usable({0, 0, 0, 2, 2, {1, 2, 3, 4}}));
  EXPECT_FALSE(is_usable({0, 0, 1, 1, 2, {1, 2}}));
  EXPECT_FALSE(is_usable({0, 0, 1, 2, 2, {1, 2, 3, std::nan("")}}));
  EXPECT_TRUE(is_usable({0, 0, 1, 2, 2, {1, 2, 3, 4}}));
}

TEST(Contours, OfAConeAreCircles) {
  const std::vector<Contour> found = contours(cone());

  ASSERT_FALSE(found.empty());
  for (const Contour& contour : found) {
    if (contour.height <= 0) continue;
    const double radius = 2 * (100 - contour.height);
    for (const auto& [a, b] : contour.segments) {
      EXPECT_NEAR(std::hypot(a.x, a.y), radius, 2.5) << contour.height;
      EXPECT_NEAR(std::hypot(b.x, b.y), radius, 2.5) << contour.height;
    }
  }
}

TEST(Contours, FlatGroundHasNone) {
  EXPECT_TRUE(contours({0, 0, 1, 2, 2, {5, 5, 5, 5.1}}).empty());
}

TEST(Contours, ASaddleIsCrossedTwice) {
  const std::vector<Contour> found = contours({0, 0, 10, 2, 2, {10, 0, 0, 10}});

  for (const Contour& contour : found) {
    if (contour.height > 0 && contour.height < 10) {
      EXPECT_EQ(contour.segments.size(), 2U);
    }
  }
}

TEST(Contours, AVeryLargeGridIsThinned) {
  TerrainGrid grid{0, 0, 1, 1500, 10, std::vector<double>(15'000)};
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    grid.values[i] = static_cast<double>(i % 1500);

  std::size_t segments = 0;
  for (const Contour& contour : contours(grid)) segments += contour.segments.size();

  EXPECT_LT(segments, 100U);
}

}  // namespace
}  // namespace skein::report
