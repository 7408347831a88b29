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
constexpr Duration kShortestPause = Duration::milliseconds(500),
                   kLongestPause = Duration::milliseconds(2'000);

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

Telling among(std::size_t members, std::size_t self) {
  return Telling(members, self, at(1), kShortestPause, kLongestPause);
}

/// Member `self` of three. The decider knows all; 1 and 2 know what is old.
Telling among_three(std::size_t self) {
  Telling telling = among(3, self);
  telling.heard(kDecider, kAll, at(1));
  telling.heard(1, kOld, at(1));
  telling.heard(2, kOld, at(1));
  return telling;
}

TEST(Telling, WhoHasNotSaidThatItKnowsAllLags) {
  Telling telling = among_three(kSelf);
  EXPECT_THAT(telling.who_lags(kAll), ElementsAre(2));
  EXPECT_THAT(telling.who_lags(kOld), IsEmpty());

  telling.heard(2, FactBits{2}, at(1));

  EXPECT_FALSE(telling.lags(2, kAll));
}

TEST(Telling, NewsGoToTheDeciderUnlessAllHaveToHear) {
  Telling telling = among(3, kSelf);

  telling.owe_news(kAll, false);
  EXPECT_THAT(telling.take_owed(kAll, at(2)), ElementsAre(kDecider));

  telling.owe_news(kAll, true);
  EXPECT_THAT(telling.take_owed(kAll, at(2)), ElementsAre(kDecider, 2));
}

TEST(Telling, NewsAreNotOwedToWhoKnowsThem) {
  Telling telling = among_three(kSelf);

  telling.owe_news(kAll, true);

  EXPECT_THAT(telling.take_owed(kAll, at(2)), ElementsAre(2));
}

TEST(Telling, WhatIsOwedIsTakenOnceAndNeverByOneself) {
  Telling telling = among(3, kSelf);
  telling.owe_all();

  EXPECT_THAT(telling.take_owed(kAll, at(2)), ElementsAre(kDecider, 2));
  EXPECT_THAT(telling.take_owed(kAll, at(3)), IsEmpty());

  EXPECT_EQ(telling.last_sent(), at(2));
}

TEST(Telling, TheDeciderRepeatsToAllWhoLagOthersToTheDecider) {
  Telling decider = among(3, kDecider);
  decider.heard(1, kOld, at(1));
  decider.heard(2, kAll, at(1));
  EXPECT_THAT(decider.repeat(kAll, false, false, at(2), kLongestPause), ElementsAre(1));

  Telling other = among(3, kSelf);
  EXPECT_THAT(other.repeat(kAll, false, false, at(2), kLongestPause), ElementsAre(kDecider));
}

TEST(Telling, WhoInvitesRepeatsToThoseWhoWereNeverHeard) {
  Telling telling = among(4, kSelf);
  telling.heard(kDecider, kAll, at(1));
  telling.heard(2, kOld, at(1));

  EXPECT_THAT(telling.repeat(kAll, false, false, at(2), kLongestPause), IsEmpty());
  EXPECT_THAT(telling.repeat(kAll, false, true, at(3), kLongestPause), ElementsAre(3));
}

TEST(Telling, WhoAsksAsksAllOthers) {
  Telling telling = among_three(kSelf);

  EXPECT_THAT(telling.repeat(kAll, true, false, at(2), kLongestPause), ElementsAre(kDecider, 2));
}

TEST(Telling, TheDeciderIsSilentThatDoesNotAnswerTwoRepetitions) {
  Telling telling = among(3, kSelf);
  telling.repeat(kAll, false, false, at(2), kLongestPause);
  EXPECT_FALSE(telling.decider_is_silent());
  telling.repeat(kAll, false, false, at(3), kLongestPause);
  EXPECT_TRUE(telling.decider_is_silent());

  telling.heard(2, kAll, at(1));
  EXPECT_TRUE(telling.decider_is_silent());
  telling.heard(kDecider, kOld, at(1));

  EXPECT_FALSE(telling.decider_is_silent());
}

TEST(Telling, TheDeciderIsNeverSilentToItself) {
  Telling telling = among(3, kDecider);
  for (const double second : {2, 3, 4})
    telling.repeat(kAll, false, false, at(second), kLongestPause);

  EXPECT_EQ(telling.unheard(), 3);
  EXPECT_FALSE(telling.decider_is_silent());
}

TEST(Telling, WhereNobodyIsToldAgainThatIsNoRepetitionButTheTimeBeginsAnew) {
  Telling telling = among_three(kSelf);

  telling.repeat(kOld, false, false, at(5), kLongestPause);

  EXPECT_EQ(telling.unheard(), 0);
  EXPECT_EQ(telling.last_sent(), at(5));
}

TEST(Telling, WhatNobodyAnswersIsToldEverMoreRarely) {
  Telling telling = among(2, kSelf);
  std::vector<double> times;
  for (int i = 0; i < 5; ++i) {
    times.push_back((telling.due() - at(0)).to_seconds());
    telling.repeat(kAll, false, false, telling.due(), kLongestPause);
  }
  EXPECT_THAT(times, ElementsAre(1.5, 2.5, 4.5, 6.5, 8.5));
}

TEST(Telling, NewsAreToldAgainAsSoonAsTheFirst) {
  Telling telling = among(2, kSelf);
  for (int i = 0; i < 3; ++i) telling.repeat(kAll, false, false, telling.due(), kLongestPause);

  telling.owe(kDecider);
  telling.take_owed(kAll, at(10));

  EXPECT_EQ(telling.due(), at(10.5));
}

TEST(Telling, WhoOnlyAsksDoesSoAgainAndAgainAfterTheSamePause) {
  Telling telling = among(2, kSelf);
  telling.ask_every(Duration::seconds(5));
  EXPECT_EQ(telling.due(), at(6));
  telling.repeat(kAll, true, false, at(6), kLongestPause);
  EXPECT_EQ(telling.due(), at(11));
}

/// The decider, of two, whose last message took so long to be answered.
Telling after_an_answer_in(double seconds) {
  Telling telling = among(2, kDecider);
  telling.tells(kSelf, kOld, at(1));
  telling.tells(kSelf, kOld, at(1.1));
  telling.heard(kSelf, kOld, at(1 + seconds));
  return telling;
}

TEST(Telling, WhereAnswersTakeLongItWaitsAsLongForThem) {
  Telling telling = after_an_answer_in(1.25);

  telling.owe(kSelf);
  telling.take_owed(kAll, at(5));

  EXPECT_EQ(telling.due(), at(6.25));
}

TEST(Telling, NoAnswerIsAwaitedForeverHoweverLongOneTook) {
  Telling telling = after_an_answer_in(60);

  telling.owe(kSelf);
  telling.take_owed(kAll, at(100));

  EXPECT_EQ(telling.due(), at(102));
}

TEST(Telling, WhatIsOnItsWayIsNotToldAgainOnDemand) {
  Telling telling = after_an_answer_in(1.25);
  telling.tells(kSelf, kAll, at(5));

  telling.owe(kSelf);
  EXPECT_THAT(telling.take_owed(kAll, at(6)), IsEmpty());
  telling.owe(kSelf);
  EXPECT_THAT(telling.take_owed(kAll | 4, at(6)), ElementsAre(kSelf));

  telling.tells(kSelf, kAll | 4, at(6));
  telling.owe(kSelf);
  EXPECT_THAT(telling.take_owed(kAll | 4, at(7.5)), ElementsAre(kSelf));
}

TEST(Telling, TheLastPausesAreShareOfTheTimeLeftButNoShorterThanAnswersTake) {
  Telling telling = among(2, kSelf);
  telling.repeat(kAll, false, false, at(5), Duration::milliseconds(100));
  EXPECT_EQ(telling.due(), at(5.5));

  Telling slow = after_an_answer_in(1.25);
  slow.repeat(kAll, false, false, at(5), Duration::milliseconds(100));
  EXPECT_EQ(slow.due(), at(6));  // the first pause, doubled
  slow.repeat(kAll, false, false, at(6), Duration::milliseconds(100));
  EXPECT_EQ(slow.due(), at(7.25));
}

}  // namespace
}  // namespace skein::interaction
