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

}  // namespace
}  // namespace skein::decision_node::testing
