// SPDX-License-Identifier: Apache-2.0
// A node without planning domain hears frontiers and notes them; what it does with them is shown by
// scenarios/meetings.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/flown_node.hpp"

namespace skein::decision_node::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

temporal::Frontier coming(double seconds) {
  const temporal::Ticks at = Duration::seconds(seconds).count();
  return {{{500, {"heliv", "marvin"}, {"heliv", "marvin"}}},
          {{temporal::Frontier::kOrigin, temporal::Frontier::arrival_of(0), at, 2 * at, 2 * at}}};
}

TEST(Meetings, WhoIsInvitedKnowsWhenTheOtherComes) {
  FlownNode node(3);

  const auto noted = all<MeetingNoted>(node.give(FrontierTold{"heliv", coming(40)}));

  ASSERT_THAT(noted, SizeIs(1));
  EXPECT_EQ(noted[0].meeting, 500U);
  EXPECT_EQ(noted[0].dates->soonest, MissionTime::seconds(40));
  EXPECT_EQ(noted[0].dates->slowest, MissionTime::seconds(80));
}

TEST(Meetings, WhatIsSaidAgainIsNoNews) {
  FlownNode node(3);
  node.give(FrontierTold{"heliv", coming(40)});

  EXPECT_THAT(all<MeetingNoted>(node.give(FrontierTold{"heliv", coming(40)})), IsEmpty());
  EXPECT_THAT(all<MeetingNoted>(node.give(FrontierTold{"heliv", coming(40.4)})), IsEmpty())
      << "less than a second";
  EXPECT_THAT(all<MeetingNoted>(node.give(FrontierTold{"heliv", coming(42)})), SizeIs(1));
}

TEST(Meetings, OfWhoDoesNotPlanItAnyMoreNothingIsKnown) {
  FlownNode node(3);
  node.give(FrontierTold{"heliv", coming(40)});

  const auto noted = all<MeetingNoted>(node.give(FrontierTold{"heliv", {}}));

  ASSERT_THAT(noted, SizeIs(1));
  EXPECT_FALSE(noted[0].dates);
}

// It says that it has 30 s before it, whenever that is.
temporal::Frontier thirty_seconds_ahead() {
  const temporal::Ticks at = Duration::seconds(30).count();
  return {{{500, {"heliv", "marvin"}, {"heliv", "marvin"}}},
          {{temporal::Frontier::kPresent, temporal::Frontier::arrival_of(0), at, at, at}}};
}

TEST(Meetings, WhoIsOutOfReachKeepsToWhatItSaidLast) {
  FlownNode node(3);
  node.give(FrontierTold{"heliv", thirty_seconds_ahead()});
  node.give(Contact{"heliv", false, false});

  EXPECT_THAT(all<MeetingNoted>(node.wake_at(60)), IsEmpty());
  node.give(Contact{"heliv", false, true});
  EXPECT_THAT(all<MeetingNoted>(node.give(FrontierTold{"heliv", thirty_seconds_ahead()})),
              SizeIs(1));
}

// ---- other algorithms ----

using temporal::Algorithm;

FlownNode that_keeps_to(std::optional<Algorithm> consistency) {
  return FlownNode(3, ContactPolicy::kContinue, consistency);
}

FrontierTold by_ground(double seconds) { return {"heliv", coming(seconds), true}; }

TEST(MeetingsByTheGround, AreHeardFromItAlone) {
  FlownNode node = that_keeps_to(Algorithm::kCip);

  EXPECT_THAT(all<MeetingNoted>(node.give(FrontierTold{"heliv", coming(40)})), IsEmpty());
  EXPECT_THAT(all<MeetingNoted>(node.give(by_ground(40))), SizeIs(1));
  EXPECT_THAT(all<MeetingNoted>(FlownNode(3).give(by_ground(40))), IsEmpty());
}

// What it was told last is of when the ground station was in reach.
TEST(MeetingsByTheGround, AreAsOldAsItsLastWord) {
  FlownNode node = that_keeps_to(Algorithm::kCip);
  node.give(FrontierTold{"heliv", thirty_seconds_ahead(), true});
  node.give(Contact{"heliv", false, false});
  EXPECT_THAT(all<MeetingNoted>(node.wake_at(60)), SizeIs(1)) << "the other's radio is no matter";
  node.give(Contact{"ground", true, false});

  EXPECT_THAT(all<MeetingNoted>(node.wake_at(120)), IsEmpty());
}

// Of a whole network as of what is left of it.
TEST(MeetingsByWholeNetworks, ArePutTogetherHere) {
  FlownNode node = that_keeps_to(Algorithm::kDipG);
  const temporal::Ticks s = Duration::seconds(1).count();
  const std::uint32_t inner = temporal::Frontier::arrival_of(1);
  const temporal::Frontier whole{{{500, {"heliv", "marvin"}, {"heliv", "marvin"}}},
                                 {{0, inner, 10 * s, 10 * s, 10 * s}, {inner, 2, s, 2 * s, 2 * s}}};

  const auto noted = all<MeetingNoted>(node.give(FrontierTold{"heliv", whole}));

  ASSERT_THAT(noted, SizeIs(1));
  EXPECT_EQ(noted[0].dates->soonest, MissionTime::seconds(11));
}

TEST(MeetingsByDates, WhoPlansNoneTellsNothing) {
  FlownNode node = that_keeps_to(Algorithm::kDipL);

  const auto effects = node.give(FrontierTold{"heliv", coming(40)});

  EXPECT_THAT(all<MeetingNoted>(effects), SizeIs(1));
  EXPECT_THAT(all<SendFrontier>(effects), IsEmpty());
}

TEST(MeetingsOfNobody, AreNotHeard) {
  FlownNode node = that_keeps_to(std::nullopt);

  EXPECT_THAT(all<MeetingNoted>(node.give(FrontierTold{"heliv", coming(40)})), IsEmpty());
}

}  // namespace
}  // namespace skein::decision_node::testing
