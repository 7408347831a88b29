// SPDX-License-Identifier: Apache-2.0
#include "../src/telling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::interaction {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::size_t kDecider = 0, kSelf = 1;
constexpr FactBits kOld = 1, kAll = 3;

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

/// Member `self` of three. The decider knows all; 1 and 2 know what is old.
Telling among_three(std::size_t self) {
  Telling telling(3, self, at(1));
  telling.heard(kDecider, kAll);
  telling.heard(1, kOld);
  telling.heard(2, kOld);
  return telling;
}

TEST(Telling, WhoHasNotSaidThatItKnowsAllLags) {
  Telling telling = among_three(kSelf);
  EXPECT_THAT(telling.who_lags(kAll), ElementsAre(2));
  EXPECT_THAT(telling.who_lags(kOld), IsEmpty());

  telling.heard(2, FactBits{2});

  EXPECT_FALSE(telling.lags(2, kAll));
}

TEST(Telling, NewsGoToTheDeciderUnlessAllHaveToHear) {
  Telling telling(3, kSelf, at(1));

  telling.owe_news(kAll, false);
  EXPECT_THAT(telling.take_owed(at(2)), ElementsAre(kDecider));

  telling.owe_news(kAll, true);
  EXPECT_THAT(telling.take_owed(at(2)), ElementsAre(kDecider, 2));
}

TEST(Telling, NewsAreNotOwedToWhoKnowsThem) {
  Telling telling = among_three(kSelf);

  telling.owe_news(kAll, true);

  EXPECT_THAT(telling.take_owed(at(2)), ElementsAre(2));
}

TEST(Telling, WhatIsOwedIsTakenOnceAndNeverByOneself) {
  Telling telling(3, kSelf, at(1));
  telling.owe_all();

  EXPECT_THAT(telling.take_owed(at(2)), ElementsAre(kDecider, 2));
  EXPECT_THAT(telling.take_owed(at(3)), IsEmpty());

  EXPECT_EQ(telling.last_sent(), at(2));
}

TEST(Telling, TheDeciderRepeatsToAllWhoLagOthersToTheDecider) {
  Telling decider(3, kDecider, at(1));
  decider.heard(1, kOld);
  decider.heard(2, kAll);
  EXPECT_THAT(decider.repeat(kAll, false, false, at(2)), ElementsAre(1));

  Telling other(3, kSelf, at(1));
  EXPECT_THAT(other.repeat(kAll, false, false, at(2)), ElementsAre(kDecider));
}

TEST(Telling, WhoInvitesRepeatsToThoseWhoWereNeverHeard) {
  Telling telling(4, kSelf, at(1));
  telling.heard(kDecider, kAll);
  telling.heard(2, kOld);

  EXPECT_THAT(telling.repeat(kAll, false, false, at(2)), IsEmpty());
  EXPECT_THAT(telling.repeat(kAll, false, true, at(3)), ElementsAre(3));
}

TEST(Telling, WhoAsksAsksAllOthers) {
  Telling telling = among_three(kSelf);

  EXPECT_THAT(telling.repeat(kAll, true, false, at(2)), ElementsAre(kDecider, 2));
}

TEST(Telling, TheDeciderIsSilentThatDoesNotAnswerTwoRepetitions) {
  Telling telling(3, kSelf, at(1));
  telling.repeat(kAll, false, false, at(2));
  EXPECT_FALSE(telling.decider_is_silent());
  telling.repeat(kAll, false, false, at(3));
  EXPECT_TRUE(telling.decider_is_silent());

  telling.heard(2, kAll);
  EXPECT_TRUE(telling.decider_is_silent());
  telling.heard(kDecider, kOld);

  EXPECT_FALSE(telling.decider_is_silent());
}

TEST(Telling, TheDeciderIsNeverSilentToItself) {
  Telling telling(3, kDecider, at(1));
  for (const double second : {2, 3, 4}) telling.repeat(kAll, false, false, at(second));

  EXPECT_EQ(telling.unheard(), 3);
  EXPECT_FALSE(telling.decider_is_silent());
}

TEST(Telling, WhereNobodyIsToldAgainThatIsNoRepetitionButTheTimeBeginsAnew) {
  Telling telling = among_three(kSelf);

  telling.repeat(kOld, false, false, at(5));

  EXPECT_EQ(telling.unheard(), 0);
  EXPECT_EQ(telling.last_sent(), at(5));
}

}  // namespace
}  // namespace skein::interaction
