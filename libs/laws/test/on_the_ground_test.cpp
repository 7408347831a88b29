// SPDX-License-Identifier: Apache-2.0
// Vehicles that keep to the ground.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using world::Vector3;

TEST(OnTheGround, WhoDrivesOverTheGroundKeepsTheLawWhoIsInTheAirDoesNot) {
  Story drives = Story::with_a_robot(), flies = Story::with_a_robot();
  drives.flies("mana", 0, 40, {0, 0, 0}, {80, 0, 0});
  flies.flies("mana", 0, 40, {0, 0, 0}, {80, 0, 30});

  EXPECT_THAT(drives.broken("on-the-ground"), IsEmpty());
  EXPECT_THAT(flies.broken("on-the-ground"), ElementsAre(HasSubstr("is in the air")));
}

TEST(OnTheGround, WhatFliesIsNotAsked) {
  Story story = Story::with_a_robot();
  story.flies("marvin", 0, 40, {0, 0, 40}, {80, 0, 40});

  EXPECT_THAT(story.broken("on-the-ground"), IsEmpty());
}

/// Stands at the foot of a hill, then so far up from where that gets too steep for it [m].
Story beyond_the_steepest(double further) {
  Story story = Story::with_a_robot();
  story.hill({{600, 300}, 60, 200});
  const world::Terrain terrain = story.terrain();
  double x = 400;
  while (terrain.slope(x, 300) <= 0.2) x += 0.01;
  x += further;
  story.stands("mana", 0, 5, {300, 300, 0});
  story.stands("mana", 6, 10, {x, 300, terrain.elevation(x, 300)});
  return story;
}

// Found by random missions (--robots --deaths 30210): its way led along the edge of what it can
// climb, and it was a hand's breadth beside it.
TEST(OnTheGround, WhoDrivesALittleBesideWhatItCanClimbKeepsTheLaw) {
  EXPECT_THAT(beyond_the_steepest(0.3).broken("on-the-ground"), IsEmpty());
  EXPECT_THAT(beyond_the_steepest(20).broken("on-the-ground"),
              ElementsAre(HasSubstr("drives over ground too steep for it")));
}

// It may stand with little of it.
TEST(OnTheGround, NobodyDrivesBelowTheReserve) {
  Story stood = Story::with_a_robot(), drove = Story::with_a_robot();
  for (int i = 0; i < 60; ++i) {
    stood.flies("mana", i, i, {0, 0, 0}, {0, 0, 0}, 0.12 - 0.001 * i);
    drove.flies("mana", i, i + 1, {2.0 * i, 0, 0}, {2.0 * i + 2, 0, 0}, 0.12 - 0.001 * i);
  }

  EXPECT_THAT(stood.broken("energy"), IsEmpty());
  EXPECT_THAT(drove.broken("energy"), ElementsAre(HasSubstr("drives with")));
}

TEST(OnTheGround, WhoIsToComeHomeIsThere) {
  const auto ends_at = [](const Vector3& at) {
    Story story = Story::with_a_robot();
    story.stands("mana", 0, 60, at);
    story.goal("mana", 700, "general-land", "received", 1);
    story.goal("mana", 700, "general-land", "achieved", 50);
    return story.broken("reached");
  };

  EXPECT_THAT(ends_at({1, 1, 0}), IsEmpty());
  EXPECT_THAT(ends_at({40, 0, 0}), ElementsAre(HasSubstr("from home")));
}

}  // namespace
}  // namespace skein::laws::testing
