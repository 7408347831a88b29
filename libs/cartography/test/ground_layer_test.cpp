// SPDX-License-Identifier: Apache-2.0
#include "ground_layer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace skein::cartography {
namespace {

world::Terrain hill() {
  world::TerrainSpec spec;
  spec.west = spec.south = -500;
  spec.east = spec.north = 500;
  spec.cell = 5;
  spec.hills = {{{0, 0}, 100, 400}};
  return world::Terrain(spec);
}

constexpr Frame kFrame{-500, -500, 500, 500};

double light_at(const Pixels& pixels, std::size_t x, std::size_t y) {
  return pixels.bytes()[(y * pixels.width() + x) * 4];
}

TEST(Scale, FitsTheFrameInThePicture) {
  const Scale wide({0, 0, 2000, 500}, 800, 600), tall({0, 0, 500, 2000}, 800, 600);

  EXPECT_DOUBLE_EQ(wide.width(), 800);
  EXPECT_DOUBLE_EQ(wide.height(), 200);
  EXPECT_DOUBLE_EQ(tall.height(), 600);
  EXPECT_DOUBLE_EQ(tall.width(), 150);
}

TEST(Scale, HasNorthUp) {
  const Scale scale(kFrame, 800, 800);

  EXPECT_DOUBLE_EQ(scale(world::Vector2(-500, 500)).x, 0);
  EXPECT_DOUBLE_EQ(scale(world::Vector2(-500, 500)).y, 0);
  EXPECT_DOUBLE_EQ(scale(world::Vector2(0, -500)).y, 800);
}

TEST(Relief, IsThatOfTheFrameOnly) {
  const Relief whole = relief_of(hill(), kFrame),
               corner = relief_of(hill(), {-500, -500, -400, -400});

  EXPECT_NEAR(whole.high, 100, 0.5);
  EXPECT_EQ(whole.low, 0);
  EXPECT_EQ(corner.high, 0);
}

TEST(HillShade, LightsTheNorthWestSlopes) {
  const world::Terrain terrain = hill();
  const Scale scale(kFrame, 400, 400);

  const Pixels pixels = hill_shade(terrain, scale, relief_of(terrain, kFrame));

  const std::size_t middle = pixels.width() / 2, off = pixels.width() / 7;
  EXPECT_GT(light_at(pixels, middle - off, middle - off),
            light_at(pixels, middle + off, middle + off));
}

TEST(ContourInterval, IsRoundAndGivesAboutTenLines) {
  EXPECT_DOUBLE_EQ(contour_interval({0, 100}), 10);
  EXPECT_DOUBLE_EQ(contour_interval({200, 1043}), 100);
  EXPECT_DOUBLE_EQ(contour_interval({0, 160}), 20);
  EXPECT_GT(contour_interval({5, 5}), 0);
}

TEST(Contours, LieWhereTheGroundHasTheirHeight) {
  const world::Terrain terrain = hill();
  const Scale scale(kFrame, 1000, 1000);  // a pixel a metre

  const std::string lines = contours(terrain, scale, relief_of(terrain, kFrame));

  const std::regex piece(R"(M([-0-9.]+) ([-0-9.]+)L)");
  std::size_t pieces = 0;
  for (std::sregex_iterator i(lines.begin(), lines.end(), piece), end; i != end; ++i, ++pieces) {
    const double height = terrain.elevation(std::stod((*i)[1]) - 500, 500 - std::stod((*i)[2]));
    EXPECT_NEAR(std::remainder(height, 10), 0, 0.4);
  }
  EXPECT_GT(pieces, 500U);
}

TEST(Contours, LevelGroundHasNone) {
  world::TerrainSpec spec;
  spec.east = spec.north = 100;
  const world::Terrain level(spec);

  EXPECT_EQ(contours(level, Scale({0, 0, 100, 100}, 100, 100), {0, 0}), "");
}

}  // namespace
}  // namespace skein::cartography
