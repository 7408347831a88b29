// SPDX-License-Identifier: Apache-2.0
// Laws about objects that move, on logs made by hand.
#include <gmock/gmock.h>

#include "testing/story.hpp"

namespace skein::laws {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Story;

/// Twenty metres long at first, thirty later.
Story blaze() {
  Story story;
  story.burns(0, {100, 50}, 10, 8).burns(60, {100, 50}, 15, 12);
  return story;
}

TEST(SeenLaw, AnObjectThatWasWhereItIsSaidToHaveBeenKeepsIt) {
  Story story = blaze();
  story.object_seen(61, 60, {120, 50, 0}, 2).object_seen(70, 65, {124 + 15, 50, 0}, 2);

  EXPECT_THAT(story.broken("seen"), IsEmpty());
}

TEST(SeenLaw, AnObjectThatWasNotThereBreaksIt) {
  Story story = blaze();
  story.object_seen(61, 60, {200, 50, 0}, 2);

  EXPECT_THAT(story.broken("seen"),
              ElementsAre(HasSubstr("'fire-front' is said to have been seen at 60.0 s where "
                                    "nothing was within 76.0 m")));
}

TEST(SeenLaw, SaysSoWhenThereWasNothingAnywhere) {
  Story story;
  story.object_seen(61, 60, {200, 50, 0}, 2);

  EXPECT_THAT(story.broken("seen"),
              ElementsAre(HasSubstr("at 60.0 s when there was nothing anywhere")));
}

// Where the front was when it was seen, not where it is when that is told.
TEST(SeenLaw, CountsWhenItWasSeen) {
  Story story;
  story.burns(0, {100, 50}, 10, 10).burns(60, {100, 50}, 60, 60);
  story.object_seen(61, 30, {155, 50, 0}, 2).object_seen(62, 60, {155, 50, 0}, 2);

  EXPECT_EQ(story.broken("seen").size(), 1U);
}

TEST(FiresLaw, AFireThatGrowsKeepsIt) { EXPECT_THAT(blaze().broken("fires"), IsEmpty()); }

TEST(FiresLaw, AFireThatShrinksOrWandersBreaksIt) {
  EXPECT_THAT(blaze().burns(90, {100, 50}, 15, 11).broken("fires"),
              ElementsAre(HasSubstr("'blaze' no longer covers where it was at 60.0 s")));
  EXPECT_EQ(blaze().burns(90, {130, 50}, 15, 12).broken("fires").size(), 1U);
}

// ---- perceived ----

// What follows an object that moves looks at (150, 60) from 80 to 140 s; at 20 s it was said to be
// there, and at 70 s elsewhere.
Story look_at_a_front(const world::Vector3& at_seventy,
                      const world::Vector3& from = {130, 60, 40}) {
  Story story;
  story.relay("heliv").object_seen(20, 20, {150, 60, 0}, 2).object_seen(70, 70, at_seventy, 2);
  story.flies("marvin", 0, 200, from, from);
  story.goal("marvin", 701, "perceive fire-front 60", "received", 1);
  story.does("marvin", {101, "takeshot", 701, 80, 140, "ended", "visible", {150, 60, 0}});
  story.goal("marvin", 701, "perceive fire-front 60", "achieved", 140);
  return story;
}

// Found by --mixed 149: a robot out of the ground station's sight, heard past two helicopters.
TEST(PerceivedLaw, WhatMovesIsLookedAtWhereItWasSaidToBeEvenPastARelay) {
  Story heard = look_at_a_front({250, 60, 0}), deaf = heard;
  heard.link(60, "ground", "marvin", false);
  deaf.link(60, "ground", "marvin", false).link(60, "heliv", "marvin", false);

  EXPECT_THAT(heard.broken("perceived"), ElementsAre(HasSubstr("of 60.0 s")));
  EXPECT_THAT(deaf.broken("perceived"), IsEmpty()) << "it was told of the first place only";
}

TEST(PerceivedLaw, WhatMovedIsInTheFieldOfTheDeviceAsItIsAimed) {
  const world::Vector3 moved{168, 60, 0}, low{150, 55, 8};

  EXPECT_THAT(look_at_a_front(moved).broken("perceived"), IsEmpty());
  EXPECT_THAT(look_at_a_front(moved, low).broken("perceived"), ElementsAre(HasSubstr("of 60.0 s")));
}

}  // namespace
}  // namespace skein::laws
