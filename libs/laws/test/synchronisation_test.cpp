// SPDX-License-Identifier: Apache-2.0
// Nobody comes to a meeting before it was foretold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(ForetoldLaw, WhoComesBeforeHeWasForetoldBreaksIt) {
  Story story;
  story.foretold("marvin", 20, 500, "heliv", 90).hears("marvin", 60, 500, "heliv");

  EXPECT_THAT(story.broken("foretold"),
              ElementsAre(HasSubstr("heliv is there for synchronisation 500, foretold at 20.0 s to "
                                    "come no earlier than 90.0 s")));
}

TEST(ForetoldLaw, WhoWasNeverToComeBreaksItByComing) {
  Story story;
  story.foretold("marvin", 20, 500, "heliv", std::nullopt).hears("marvin", 60, 500, "heliv");

  EXPECT_THAT(story.broken("foretold"), ElementsAre(HasSubstr("to come never")));
}

TEST(ForetoldLaw, TheLastWordCounts) {
  Story story;
  story.foretold("marvin", 20, 500, "heliv", 90).foretold("marvin", 50, 500, "heliv", 60);
  story.hears("marvin", 60, 500, "heliv");

  EXPECT_THAT(story.broken("foretold"), IsEmpty());
}

// After a cut: the words that waited come after the state.
TEST(ForetoldLaw, WhatComesWithItsWithdrawalWasSaidLongAgo) {
  Story story;
  story.foretold("marvin", 60, 500, "heliv", 90).hears("marvin", 60, 500, "heliv");
  story.hears("marvin", 60, 500, "heliv", "withdrawn");

  EXPECT_THAT(story.broken("foretold"), IsEmpty());
}

TEST(ForetoldLaw, OfAnotherMeetingOrAnotherUavNothingIsSaid) {
  Story story;
  story.foretold("marvin", 20, 501, "heliv", 90).foretold("marvin", 20, 500, "karma", 90);
  story.hears("marvin", 60, 500, "heliv");

  EXPECT_THAT(story.broken("foretold"), IsEmpty());
}

}  // namespace
}  // namespace skein::laws::testing
