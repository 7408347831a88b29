// SPDX-License-Identifier: Apache-2.0
// Who has waited long takes precedence, where it gains by it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/merging/merger.hpp"
#include "testing/net.hpp"
#include "testing/street.hpp"

namespace skein::merging {
namespace {

using ::testing::ElementsAre;
using testing::expect_why;
using testing::kA;
using testing::kB;
using testing::kC;
using testing::Net;
using testing::place;
using testing::stretch;

TEST(Precedence, NobodyComesToStayWhereOneWantsToGoThatHasWaitedLong) {
  Net net({kA, kB, kC});
  net.stands(kB, place(50));
  net.run_for(0.1);
  net.wants(kC, {{stretch(0, 100)}});
  net.run_for(60);
  net.wants(kA, {{stretch(150, 90)}});
  net.run_for(1);
  EXPECT_TRUE(net.has_what_it_wanted(kA)) << "not so long yet";
  net.give(kA, Hold{{place(150)}});

  net.run_for(200);
  net.wants(kA, {{stretch(150, 90)}});
  net.run_for(5);
  EXPECT_FALSE(net.has_what_it_wanted(kA));
  expect_why(net, kA, kC, Awaited::kToGoFirst);
  net.give(kB, Hold{});
  net.run_for(0.5);
  EXPECT_TRUE(net.has_what_it_wanted(kC));
}

TEST(Precedence, WhoFliesThroughAndStaysElsewhereNeedNotWaitForThat) {
  Net net({kA, kB, kC});
  net.stands(kB, place(50));
  net.run_for(0.1);
  net.wants(kC, {{stretch(0, 100)}});
  net.run_for(300);
  net.wants(kA, {{stretch(150, 90), place(150)}});
  net.run_for(1);
  EXPECT_TRUE(net.has_what_it_wanted(kA));
}

TEST(Precedence, InACircleWhoHasWaitedLongMovesLast) {
  Net net({kA, kB});
  net.stands(kA, place(0));
  net.stands(kB, place(100));
  net.run_for(0.1);
  net.wants(kB, {{stretch(0, 100)}});
  net.run_for(300);
  net.wants(kA, {{stretch(0, 100)}});
  net.run_for(0.6);
  EXPECT_THAT(net.asked_aside(), ElementsAre(kA));
}

TEST(Precedence, AFlightAsideTakesNothingFromHowLongOneHasWaited) {
  Net net({kA, kB, kC});
  net.stands(kB, place(50));
  net.run_for(0.1);
  net.wants(kC, {{stretch(0, 100)}});
  net.run_for(200);
  net.give(kC, Want{{{stretch(200, 210)}}, {stretch(0, 100)}});
  net.run_for(1);
  ASSERT_TRUE(net.has_what_it_wanted(kC));
  net.run_for(50);
  net.wants(kC, {{stretch(0, 100)}});
  net.run_for(1);

  net.wants(kA, {{stretch(150, 90)}});
  net.run_for(5);
  expect_why(net, kA, kC, Awaited::kToGoFirst);
}

// Its landing is what makes the air free that C has waited for.
TEST(Precedence, WhoLandsNeedNotWaitForWhoHasWaitedLong) {
  Net net({kA, kB, kC});
  net.stands(kA, place(90));
  net.stands(kB, place(50));
  net.run_for(0.1);
  net.wants(kC, {{stretch(0, 90)}});
  net.run_for(300);
  net.wants(kA, {{place(90)}});
  net.run_for(0.3);
  ASSERT_FALSE(net.has_what_it_wanted(kA));
  net.give(kA, Want{{{place(90)}}, {}, true});
  net.run_for(0.3);
  EXPECT_TRUE(net.has_what_it_wanted(kA));
}

// Found by random missions (--mixed --merged 991003): it waited for one out of its reach, too, and
// held up another for 360 s.
TEST(Precedence, WhoCannotAskTakesNoneUntilItCan) {
  const std::string kFar = "far";
  Net net({kFar, kA, kB, kC});
  net.stands(kB, place(50));
  net.run_for(0.1);
  net.wants(kC, {{stretch(0, 100)}});
  net.run_for(300);
  net.cut(kFar, kC);
  net.run_for(2);
  net.wants(kA, {{stretch(150, 90)}});
  net.run_for(1);
  ASSERT_TRUE(net.has_what_it_wanted(kA));

  net.give(kA, Hold{{place(150)}});
  net.cut(kFar, kC, false);
  net.run_for(2);
  net.wants(kA, {{stretch(150, 90)}});
  net.run_for(5);
  EXPECT_FALSE(net.has_what_it_wanted(kA));
  expect_why(net, kA, kC, Awaited::kToGoFirst);
}

}  // namespace
}  // namespace skein::merging
