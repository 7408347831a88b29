// SPDX-License-Identifier: Apache-2.0
// A claim is told until it has arrived, and then no more until it is another.
#include "skein/merging/exchange.hpp"

#include <gtest/gtest.h>

namespace skein::merging {
namespace {

constexpr Duration kBeat = Duration::milliseconds(1'000), kPause = Duration::milliseconds(8'000);

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }
Claim holding(double to) { return {{{{0, 0}, {to, 0}, 5, 30, 50}}, 0, {}, {}}; }

/// Of the other, which says that it has this version of the own claim.
Message saying(std::uint64_t number, const Claim& claim, std::uint64_t known = 0) {
  Message message;
  message.number = number;
  message.claim = claim;
  message.version = number;
  message.known = known;
  return message;
}

Message brief(std::uint64_t number, std::uint64_t version) {
  Message message = saying(number, {});
  message.version = version;
  message.brief = true;
  return message;
}

TEST(Exchange, AClaimIsLeftOutOnceItHasArrived) {
  Exchange exchange;
  const Message first = exchange.tell(holding(10), 7, at(1), kBeat);
  EXPECT_FALSE(first.brief);
  EXPECT_EQ(first.claim, holding(10));
  EXPECT_EQ(first.version, 7U);
  EXPECT_TRUE(exchange.hear(saying(1, {}, 7), at(2)));
  const Message second = exchange.tell(holding(10), 8, at(2), kBeat);
  EXPECT_TRUE(second.brief);
  EXPECT_EQ(second.claim, Claim());
  EXPECT_EQ(second.version, 7U) << "it is the same claim";
  EXPECT_EQ(second.number, 8U);
}

TEST(Exchange, AnotherClaimIsToldInFullAgain) {
  Exchange exchange;
  exchange.tell(holding(10), 7, at(1), kBeat);
  exchange.hear(saying(1, {}, 7), at(2));
  const Message other = exchange.tell(holding(20), 8, at(2), kBeat);
  EXPECT_FALSE(other.brief);
  EXPECT_EQ(other.version, 8U);
  exchange.hear(saying(2, {}, 7), at(2));  // sent before it came
  EXPECT_FALSE(exchange.tell(holding(20), 9, at(4), kBeat).brief);
}

TEST(Exchange, WhatDidNotArriveIsDueEverMoreRarely) {
  Exchange exchange;
  exchange.tell(holding(10), 7, at(1), kBeat);
  EXPECT_EQ(exchange.due(), at(3)) << "until then it may arrive";
  EXPECT_FALSE(exchange.is_due(at(2.9)));
  exchange.tell(holding(10), 8, at(3), kBeat);
  exchange.told_again(at(3), kPause);
  EXPECT_EQ(exchange.due(), at(5));
  for (double now = 5; now < 40; now = exchange.due()->to_seconds())
    exchange.told_again(at(now), kPause);
  EXPECT_EQ(*exchange.due() - at(33), kPause) << "more rarely than that it is not told";
  exchange.hear(saying(1, {}, 7), at(2));
  EXPECT_EQ(exchange.due(), std::nullopt);
  EXPECT_FALSE(exchange.is_due(at(100)));
}

// On a narrow channel it waits behind others, and each time in full would keep those waiting
// longer.
TEST(Exchange, AClaimThatMayBeOnItsWayIsLeftOut) {
  Exchange exchange;
  exchange.tell(holding(10), 7, at(1), kBeat);
  const Message second = exchange.tell(holding(10), 8, at(2.9), kBeat);
  EXPECT_TRUE(second.brief);
  EXPECT_EQ(second.version, 7U);
  EXPECT_FALSE(exchange.tell(holding(10), 9, at(3), kBeat).brief) << "it has expired";
  EXPECT_FALSE(exchange.tell(holding(20), 10, at(3.1), kBeat).brief) << "another one";
  exchange.hear(saying(1, {}, 7), at(2));
  EXPECT_TRUE(exchange.tell(holding(20), 11, at(3.2), kBeat).brief) << "it said so before it came";
}

TEST(Exchange, WhoLacksWhatWasLeftOutIsToldInFull) {
  Exchange one, other;
  one.tell(holding(10), 7, at(1), kBeat);  // is lost
  EXPECT_FALSE(other.hear(one.tell(holding(10), 8, at(1.5), kBeat), at(1.5)));
  const Message answer = other.tell({}, 3, at(1.6), kBeat);
  EXPECT_TRUE(answer.lacks);
  one.hear(answer, at(1.6));
  const Message again = one.tell(holding(10), 9, at(1.7), kBeat);
  EXPECT_FALSE(again.brief);
  EXPECT_TRUE(other.hear(again, at(1.7)));
  EXPECT_FALSE(other.tell({}, 4, at(1.8), kBeat).lacks);
}

// What was told again may have arrived the first time.
TEST(Exchange, ARoundTripIsThatOfAClaimThatWasToldOnce) {
  Exchange exchange;
  exchange.tell(holding(10), 7, at(1), kBeat);
  exchange.tell(holding(10), 8, at(2), kBeat);
  EXPECT_EQ(exchange.round_trip(), Duration());
  exchange.hear(saying(1, {}, 7), at(2.5));
  EXPECT_EQ(exchange.round_trip(), Duration::milliseconds(1'500));
  exchange.hear(saying(2, {}, 7), at(9));
  EXPECT_EQ(exchange.round_trip(), Duration::milliseconds(1'500));

  exchange.tell(holding(20), 9, at(10), kBeat);
  exchange.tell(holding(20), 10, at(12), kBeat);
  exchange.hear(saying(3, {}, 9), at(12.1));
  EXPECT_EQ(exchange.round_trip(), Duration::milliseconds(1'500));
}

TEST(Exchange, ACutMayHaveTakenWhatWasOnItsWay) {
  Exchange exchange;
  exchange.tell(holding(10), 7, at(1), kBeat);
  exchange.is_cut();
  EXPECT_FALSE(exchange.tell(holding(10), 8, at(1.5), kBeat).brief);
}

TEST(Exchange, ANewClaimIsDueAfterABeatAgain) {
  Exchange exchange;
  exchange.tell(holding(10), 7, at(1), kBeat);
  exchange.hear(saying(1, {}, 7), at(2));
  exchange.claims(holding(10), kBeat);
  EXPECT_EQ(exchange.due(), std::nullopt) << "it is what the other has";
  exchange.claims(holding(20), kBeat);
  EXPECT_EQ(exchange.due(), at(3));
  EXPECT_FALSE(exchange.tell(holding(20), 8, at(2), kBeat).brief);
}

TEST(Exchange, WhoLeavesOutAClaimThatIsNotKnownHereIsTold) {
  Exchange exchange;
  EXPECT_FALSE(exchange.hear(brief(3, 2), at(2)));
  EXPECT_FALSE(exchange.has_heard());
  EXPECT_FALSE(exchange.is_old(saying(3, {}))) << "nothing was taken from it";
  EXPECT_EQ(exchange.tell({}, 1, at(1), kBeat).known, 0U);
}

TEST(Exchange, WhatWasLeftOutIsWhatWasSaidBefore) {
  Exchange exchange;
  exchange.hear(saying(2, holding(30)), at(2));
  EXPECT_EQ(exchange.tell({}, 1, at(1), kBeat).known, 2U);
  EXPECT_TRUE(exchange.hear(brief(3, 2), at(2)));
  EXPECT_EQ(exchange.claim(), holding(30));
  EXPECT_TRUE(exchange.is_old(saying(3, {})));
  EXPECT_FALSE(exchange.is_old(saying(4, {})));
}

TEST(Exchange, WhatTheWitnessPassesOnSaysNothingOfWhatArrived) {
  Exchange exchange;
  exchange.tell(holding(10), 7, at(1), kBeat);
  exchange.hear(saying(1, {}, 7), at(2));
  Message passed_on = saying(2, holding(30));
  passed_on.of = "heliv";
  passed_on.version = 0;
  EXPECT_TRUE(exchange.hear(passed_on, at(2)));
  EXPECT_EQ(exchange.claim(), holding(30));
  EXPECT_TRUE(exchange.tell(holding(10), 8, at(2), kBeat).brief);
}

}  // namespace
}  // namespace skein::merging
