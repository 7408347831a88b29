// SPDX-License-Identifier: Apache-2.0
#include "skein/world/radio_model.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace skein::world {
namespace {

Terrain terrain() {
  TerrainSpec spec;
  spec.west = spec.south = -500;
  spec.east = spec.north = 500;
  spec.hills = {{{0, 0}, 50, 100}};
  return Terrain(spec);
}

const RadioModel kRadio = {300, true, Duration::milliseconds(20), 0.01, 0.1};

TEST(RadioModel, IsUpWithinRangeInSight) {
  const RadioLink link = kRadio.link({-100, 200, 10}, {100, 200, 10}, terrain(), false);

  EXPECT_EQ(link, (RadioLink{true, Duration::milliseconds(20), 0.01}));
}

TEST(RadioModel, TerrainCutsOnlyWhoNeedsSight) {
  RadioModel through_hills = kRadio;
  through_hills.needs_line_of_sight = false;

  EXPECT_FALSE(kRadio.link({-100, 0, 10}, {100, 0, 10}, terrain(), true).up);
  EXPECT_TRUE(through_hills.link({-100, 0, 10}, {100, 0, 10}, terrain(), true).up);
}

TEST(RadioModel, HoldsABitBeyondItsRangeOnceUp) {
  const Vector3 a(-200, 200, 60), b(115, 200, 60);  // 315 m

  EXPECT_FALSE(kRadio.link(a, b, terrain(), false).up);
  EXPECT_TRUE(kRadio.link(a, b, terrain(), true).up);
  EXPECT_FALSE(kRadio.link(a, b + Vector3(20, 0, 0), terrain(), true).up);
}

TEST(RadioModel, ADownLinkLosesEverything) {
  EXPECT_EQ(kRadio.link({-400, 0, 10}, {400, 0, 10}, terrain(), true),
            (RadioLink{false, Duration(), 1}));
}

RC_GTEST_PROP(RadioModel, IsSymmetrical, (bool was_up)) {
  const Terrain ground = terrain();
  const auto end = [] {
    return Vector3(*rc::gen::inRange(-400, 400), *rc::gen::inRange(-400, 400),
                   *rc::gen::inRange(0, 100));
  };
  const Vector3 a = end(), b = end();

  RC_ASSERT(kRadio.link(a, b, ground, was_up) == kRadio.link(b, a, ground, was_up));
}

}  // namespace
}  // namespace skein::world
