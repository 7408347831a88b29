// SPDX-License-Identifier: Apache-2.0
// Who waits for each other for his air, and for how long.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/journal/lines/deliberation.hpp"
#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Marvin and Heliv want each other's air from 20 s on, until Heliv gets out of the way.
Story blocked(double until) {
  Story story;
  story.stands("marvin", 0, 100).stands("heliv", 0, 100).stands("karma", 0, 100);
  story.air("marvin", 18, "waits", "heliv to leave").air("heliv", 20, "waits", "marvin to leave");
  return story.air("heliv", until, "aside");
}

TEST(MutualLaw, TwoWhoWaitForEachOtherForMoreThanTwoSecondsBreakIt) {
  EXPECT_THAT(blocked(25).broken("mutual"),
              ElementsAre(HasSubstr("wait for each other for their air, for 5.0 s")));
}

// Found by random missions (--anything 989005).
TEST(MutualLaw, WhoseEngineHasFailedGetsOutOfNobodysWay) {
  EXPECT_THAT(blocked(25).fault(21, "engine", "heliv").broken("mutual"), IsEmpty());
  EXPECT_THAT(blocked(25).fault(26, "engine", "heliv").broken("mutual"), SizeIs(1));
  EXPECT_THAT(blocked(25).fault(21, "engine", "karma").broken("mutual"), SizeIs(1));
}

// Found by an outsider's missions (34): a fault that was to abort a flight met the one aside.
TEST(MutualLaw, WhoseFlightAsideAFaultAbortsIsAskedAgainAfterTenSeconds) {
  const auto aborted = [](double until, const std::string& reason) {
    Story story = blocked(until);
    story.does("heliv", {900, "goto", 0, 21, 21, "aborted", "", {}, reason});
    return story.broken("mutual");
  };
  EXPECT_THAT(aborted(31.9, "aborted by the functional layer"), IsEmpty());
  EXPECT_THAT(aborted(32.5, "aborted by the functional layer"), SizeIs(1));
  EXPECT_THAT(aborted(31.9, "interrupted"), SizeIs(1));
}

// Found by random missions (--mixed --merged 1002117): the other moved, once a third one had
// passed.
TEST(MutualLaw, WhoseEnergyDoesNotLastToGetOutOfTheWayIsWaitedForForTenSecondsMore) {
  const auto with = [](double energy, double until) {
    Story story;
    story.flies("marvin", 0, 100, {0, 0, 60}, {0, 0, 60}, energy).stands("heliv", 0, 100);
    story.air("marvin", 18, "waits", "heliv to leave").air("heliv", 20, "waits", "marvin to leave");
    return story.air("heliv", until, "aside").broken("mutual");
  };
  EXPECT_THAT(with(0.09, 31.9), IsEmpty());
  EXPECT_THAT(with(0.09, 32.5), SizeIs(1));
  EXPECT_THAT(with(0.5, 31.9), SizeIs(1));
}

TEST(MutualLaw, WhoGetsOutOfTheWayWithinTwoSecondsKeepsIt) {
  EXPECT_THAT(blocked(21.9).broken("mutual"), IsEmpty());
}

TEST(MutualLaw, OnNarrowLinksItIsLongerByTheWordsThatEndIt) {
  for (const auto& [capacity, longest] : {std::pair(9'600.0, 4.25), std::pair(57'600.0, 2.375)}) {
    EXPECT_THAT(blocked(20 + longest - 0.1).capacity(capacity).broken("mutual"), IsEmpty());
    EXPECT_THAT(blocked(20 + longest + 0.1).capacity(capacity).broken("mutual"), SizeIs(1));
  }
}

TEST(MutualLaw, PastRelaysEachWordTakesTwoOfThem) {
  EXPECT_THAT(blocked(26.4).capacity(9'600).relay("karma").broken("mutual"), IsEmpty());
  EXPECT_THAT(blocked(26.6).capacity(9'600).relay("karma").broken("mutual"), SizeIs(1));
  EXPECT_THAT(blocked(22.1).relay("karma").broken("mutual"), SizeIs(1)) << "they take no time";
}

// However long: the other flies, and leaves.
TEST(MutualLaw, AWaitForOneThatDoesNotWaitIsNoneOfThese) {
  Story story;
  story.stands("marvin", 0, 100).stands("heliv", 0, 100);
  story.air("marvin", 10, "waits", "heliv to leave").air("heliv", 5, "had");

  EXPECT_THAT(story.broken("mutual"), IsEmpty());
}

TEST(MutualLaw, ACircleOfThreeIsOne) {
  Story story;
  story.stands("marvin", 0, 100).stands("heliv", 0, 100).stands("karma", 0, 100);
  story.air("marvin", 10, "waits", "heliv to leave").air("heliv", 11, "waits", "karma to leave");
  story.air("karma", 12, "waits", "heliv to be answered itself; marvin to leave");

  EXPECT_THAT(story.broken("mutual"), SizeIs(3));
}

TEST(MutualLaw, WhoIsToAnswerOrToComeIntoReachIsInNobodysWay) {
  Story story;
  story.stands("marvin", 0, 100).stands("heliv", 0, 100);
  story.air("marvin", 10, "waits", "heliv to be answered itself");
  story.air("heliv", 11, "waits", "marvin to come into reach");

  EXPECT_THAT(story.broken("mutual"), IsEmpty());
}

TEST(MutualLaw, AMotionThatIsGivenUpWaitsNoMore) {
  Story story = blocked(60);
  story.air("marvin", 21, "given-up");

  EXPECT_THAT(story.broken("mutual"), IsEmpty());
}

TEST(MutualLaw, WhileSomeLinkIsDownNobodyIsBlamed) {
  Story story = blocked(60);
  story.link(0, "karma", "heliv", true).link(40, "karma", "heliv", false);

  EXPECT_THAT(story.broken("mutual"), IsEmpty());
}

TEST(MutualLaw, OneThatStandsUntilTheEndOfTheLogCounts) {
  Story story = blocked(60);
  story.air("heliv", 61, "waits", "marvin to leave");

  EXPECT_THAT(story.broken("mutual"), SizeIs(2));
}

/// Heliv is in the air at the origin; Marvin waits from 20 s on for it to leave a way of 400 m that
/// begins so far east of there.
Story keeps_from(double east, double until = 300) {
  Story story;
  story.flies("heliv", 0, until, {0, 0, 40}, {0, 0, 40}).stands("marvin", 0, until);
  return story.line(journal::record_of(
      MissionTime::seconds(20), "marvin",
      journal::lines::Air{.uav = "marvin",
                          .task = 7,
                          .type = "goto",
                          .state = "waits",
                          .for_ = "heliv to leave",
                          .wants = std::vector<double>{east, 0, east + 400, 0, 50, 30, 50}}));
}

TEST(UnusedAirLaw, WhoStaysFarFromTheAirThatAnotherWaitsForBreaksIt) {
  EXPECT_THAT(keeps_from(800).broken("unused-air"),
              ElementsAre(HasSubstr("it waits for heliv to leave air that this has not used for "
                                    "120.0 s, far from there")));
  EXPECT_THAT(keeps_from(400).broken("unused-air"), IsEmpty()) << "it is near";
  EXPECT_THAT(keeps_from(800, 130).broken("unused-air"), IsEmpty()) << "it has not waited long";
}

TEST(UnusedAirLaw, WhoIsOnItsWayMayHaveAllOfIt) {
  Story story = keeps_from(800);
  story.does("heliv", {3, "goto", 0, 10, 290});

  EXPECT_THAT(story.broken("unused-air"), IsEmpty());
}

TEST(UnusedAirLaw, WhomItDoesNotHearNobodyBlames) {
  Story story = keeps_from(800);
  story.link(0, "marvin", "heliv", true).link(40, "marvin", "heliv", false);

  EXPECT_THAT(story.broken("unused-air"), IsEmpty());
}

}  // namespace
}  // namespace skein::laws::testing
