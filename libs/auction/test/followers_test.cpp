// SPDX-License-Identifier: Apache-2.0
// What the holder hears of the others, and how often it tells one the ledger that does not answer.
#include "followers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::auction {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr Duration kBeat = Duration::milliseconds(500);

class TheHolder : public ::testing::Test {
 protected:
  static MissionTime at(double seconds) { return MissionTime::seconds(seconds); }
  void hears(MemberNumber member, std::uint64_t revision, double now, bool bids = true) {
    Status status;
    status.revision = revision;
    status.bids = bids;
    followers.hear(member, status, at(now));
  }
  /// In how many beats from 10 s on a member that is silent is told the ledger.
  int told_in(int beats) {
    int told = 0;
    for (int i = 0; i < beats; ++i)
      told += followers.is_told(one, 7, at(10 + 0.5 * i), kBeat) ? 1 : 0;
    return told;
  }

  const MemberNumber one{1}, other{2};
  Followers followers;
};

TEST_F(TheHolder, KnowsWhoWasHeardLately) {
  hears(one, 3, 10);
  hears(other, 3, 20, false);
  EXPECT_THAT(followers.heard_since(at(10)), ElementsAre(one, other));
  EXPECT_THAT(followers.heard_since(at(15)), ElementsAre(other));
  EXPECT_THAT(followers.bidding_since(at(10)), ElementsAre(one)) << "the other does not bid";
  EXPECT_EQ(followers.heard(other), at(20));
  EXPECT_EQ(followers.heard(MemberNumber(3)), std::nullopt);
  EXPECT_FALSE(followers.has_heard(MemberNumber(3)));
}

TEST_F(TheHolder, CountsTheGreatestRevisionOfOneThatLostItsDisk) {
  hears(one, 5, 10);
  hears(one, 0, 20);
  hears(other, 4, 20);
  EXPECT_TRUE(followers.has(one, 5));
  EXPECT_FALSE(followers.has(one, 6));
  EXPECT_FALSE(followers.has(MemberNumber(3), 0));
  EXPECT_THAT(followers.with(5), ElementsAre(one));
  EXPECT_THAT(followers.revisions(), ElementsAre(5U, 4U));
  EXPECT_TRUE(followers.is_told(one, 5, at(21), kBeat)) << "it has it no more";
}

TEST_F(TheHolder, TakesNewsOnce) {
  hears(one, 3, 10);
  hears(one, 4, 11);
  const auto news = followers.take_news();
  ASSERT_THAT(news, SizeIs(1));
  EXPECT_EQ(news.front().second.revision, 4U);
  EXPECT_THAT(followers.take_news(), IsEmpty());
}

TEST_F(TheHolder, TellsWhoHasTheLedgerNothing) {
  hears(one, 7, 10);
  EXPECT_EQ(told_in(20), 0);
}

TEST_F(TheHolder, TellsWhoIsSilentTheLedgerEverMoreRarely) {
  EXPECT_EQ(told_in(2), 2) << "at first in each beat";
  const int later = told_in(100);
  EXPECT_GT(later, 5);
  EXPECT_LT(later, 20) << "at last in each eighth";
}

TEST_F(TheHolder, TellsWhoAnswersWhatItWasToldOftenAgain) {
  told_in(100);
  hears(one, 7, 61);
  int told = 0;
  for (int i = 0; i < 2; ++i) told += followers.is_told(one, 8, at(62 + 0.5 * i), kBeat) ? 1 : 0;
  EXPECT_EQ(told, 2);
}

}  // namespace
}  // namespace skein::auction
