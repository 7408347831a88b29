// SPDX-License-Identifier: Apache-2.0
// How long a joint task that loads is tried, and since when it waits for its partners.
#include "interaction/loading_time.hpp"

#include <gtest/gtest.h>

namespace skein::decision_node {
namespace {

constexpr double kEver = 2e8;  // [s]

class LoadingTimes : public ::testing::Test {
 protected:
  static MissionTime at(double seconds) { return MissionTime::seconds(seconds); }
  void plan(double least, double most, double now) {
    time.plan({{Duration::seconds(least), Duration::seconds(most)}}, at(now));
  }

  LoadingTime time;
};

TEST_F(LoadingTimes, ItIsTriedUntilItIsToStartAtTheLatest) {
  time.plan({{Duration::seconds(50), Duration::seconds(60)},
             {Duration::seconds(100), Duration::seconds(300)}},
            at(10));
  EXPECT_EQ(time.until(), at(300));
  EXPECT_EQ(time.since(at(0)), at(50)) << "before that nobody is waited for";
}

TEST_F(LoadingTimes, WithoutALatestStartItIsTriedForAWhile) {
  plan(0, kEver, 10);
  EXPECT_EQ(time.until(), at(10) + LoadingTime::kTryFor);
  EXPECT_EQ(time.since(at(0)), at(10));
}

TEST_F(LoadingTimes, PlansThatAreMadeAnewDoNotProlongIt) {
  plan(0, kEver, 10);
  plan(200, kEver, 200);
  EXPECT_EQ(time.until(), at(10) + LoadingTime::kTryFor);
  EXPECT_EQ(time.since(at(0)), at(10));
}

TEST_F(LoadingTimes, APlanToStartMuchLaterBeginsItAnew) {
  plan(0, kEver, 10);
  plan(500, kEver, 20);
  EXPECT_EQ(time.since(at(0)), at(500));
  plan(20, kEver, 30);
  EXPECT_EQ(time.since(at(0)), at(30));
}

TEST_F(LoadingTimes, WhatHasRunAndFailedIsTriedForAShorterTime) {
  time.follows({true, std::nullopt});
  plan(0, kEver, 10);
  EXPECT_EQ(time.until(), at(10) + LoadingTime::kTryAgainFor);
}

TEST_F(LoadingTimes, TheWaitOfOneThatHasJustFailedGoesOn) {
  time.follows({false, at(3)});
  plan(0, kEver, 10);
  EXPECT_EQ(time.since(at(0)), at(3));
  EXPECT_EQ(time.until(), at(3) + LoadingTime::kTryFor);
  plan(400, kEver, 20);
  EXPECT_EQ(time.since(at(0)), at(400)) << "it does not wait before it can start";
}

// Found by random missions (--deaths 1008012): a partner that was there and had been refused the
// joint task was waited for three times 600 s in the air.
TEST_F(LoadingTimes, OneThatFailedAfterAllItsTimeIsTriedForAShorterTime) {
  const MissionTime given_up = at(3) + LoadingTime::kTryFor;
  time.follows({false, at(3)});
  plan(0, kEver, (given_up - MissionTime()).to_seconds());
  EXPECT_EQ(time.until(), given_up + LoadingTime::kTryAgainFor);
}

TEST_F(LoadingTimes, WhoIsEngagedIsWaitedForAMinuteLongerUnlessItIsTooLateThen) {
  plan(0, kEver, 10);
  time.engage("heliv", at(900), at(20));
  EXPECT_EQ(time.waits_until(), at(900));
  EXPECT_EQ(time.until(), at(900) + LoadingTime::kTryAgainFor);
  plan(0, 300, 30);
  EXPECT_EQ(time.until(), at(300));
}

TEST_F(LoadingTimes, WhoIsEngagedNoMoreWasUntilNow) {
  plan(0, kEver, 10);
  time.engage("heliv", at(900), at(20));
  time.engage("heliv", std::nullopt, at(700));
  EXPECT_EQ(time.until(), at(700) + LoadingTime::kTryAgainFor);
  time.engage("heliv", std::nullopt, at(750));
  EXPECT_EQ(time.until(), at(700) + LoadingTime::kTryAgainFor) << "it says so once more";
}

TEST_F(LoadingTimes, WhoIsEngagedItselfWaitsForNobodyYet) {
  plan(0, kEver, 10);
  time.engage(at(900));
  EXPECT_EQ(time.since(at(300)), at(300));
  EXPECT_EQ(time.waits_until(), at(900));
  time.engage(std::nullopt);
  EXPECT_EQ(time.since(at(300)), at(10));
}

TEST_F(LoadingTimes, AStartThatWasAgreedAndDidNotComeAboutIsTriedForAMinuteMore) {
  plan(0, kEver, 10);
  time.agree(at(2000));
  EXPECT_EQ(time.until(), at(2000) + LoadingTime::kTryAgainFor);
}

TEST_F(LoadingTimes, WhoWasEngagedAtTheAttemptBeforeIsStill) {
  time.follows({false, std::nullopt, {{"heliv", at(900)}}});
  plan(0, kEver, 10);
  EXPECT_EQ(time.until(), at(900) + LoadingTime::kTryAgainFor);
}

TEST_F(LoadingTimes, WhatWaitedForSomethingElseBeginsToWaitForPartners) {
  plan(0, kEver, 10);
  time.put_off({{Duration(), Duration::seconds(kEver)}}, at(500));
  EXPECT_EQ(time.since(at(0)), at(500));
  EXPECT_EQ(time.until(), at(500) + LoadingTime::kTryFor);
}

}  // namespace
}  // namespace skein::decision_node
