// SPDX-License-Identifier: Apache-2.0
#include "contact_check.hpp"

#include <gtest/gtest.h>

#include "worlds.hpp"

namespace skein::sampling {
namespace {

TEST(ContactCheck, RelaysCountOnlyIfTheyHaveALinkThemselves) {
  world::World world = a_plain();
  world.radio.range = 300;
  // The second is reached over the first, given later; the third by nobody.
  const ContactCheck sut({{0, 0, 50}, {{500, 0, 50}, {250, 0, 50}, {0, 900, 50}}}, world);

  EXPECT_TRUE(sut.has_link({100, 0, 50}));
  EXPECT_TRUE(sut.has_link({790, 0, 50}));
  EXPECT_FALSE(sut.has_link({810, 0, 50}));
  EXPECT_FALSE(sut.has_link({0, 800, 50}));
}

TEST(ContactCheck, ASegmentIsLostWhereAHillHidesItsMiddle) {
  world::World world = a_plain();
  world::TerrainSpec terrain = world.terrain.spec();
  terrain.hills = {{{500, 500}, 100, 100}};
  world.terrain = world::Terrain(terrain);
  const ContactCheck sut({{500, 100, 5}, {}}, world);

  EXPECT_TRUE(sut.has_link({100, 900, 20}));
  EXPECT_TRUE(sut.has_link({900, 900, 20}));
  EXPECT_FALSE(sut.has_link({100, 900, 20}, {900, 900, 20}));
  EXPECT_TRUE(sut.has_link({100, 300, 20}, {900, 300, 20}));
  EXPECT_TRUE(sut.has_link({100, 300, 20}, {100, 300, 20}));
}

}  // namespace
}  // namespace skein::sampling
