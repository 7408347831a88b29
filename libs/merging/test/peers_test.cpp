// SPDX-License-Identifier: Apache-2.0
// What is known of the others: what they have and want, where they stay, who waits longer.
#include "skein/merging/peers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/merging/merger.hpp"

namespace skein::merging {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Volume spot(double at) { return {{at, 0}, {at, 0}, 5, 30, 50}; }

/// Of b, among a, b, c.
Peers others(bool with_witness = false) { return Peers({"a", "b", "c"}, "b", with_witness); }

void says(Peers& peers, const std::string& who, Volumes held, Volumes wanted,
          std::uint64_t request = 0) {
  Exchange& exchange = peers.find(who)->exchange;
  Message message;
  message.number = 1;
  while (exchange.is_old(message)) ++message.number;
  message.claim = {std::move(held), request, std::move(wanted), {}};
  exchange.hear(message, MissionTime());
}

TEST(Peers, TheEarlierOfTheRosterDecides) {
  const Peers peers = others();
  EXPECT_TRUE(peers.find("a")->earlier);
  EXPECT_FALSE(peers.find("c")->earlier);
  EXPECT_EQ(peers.find("b"), nullptr) << "it is itself";
  EXPECT_EQ(peers.find("d"), nullptr);
}

TEST(Peers, WithAWitnessTheWordOfTheLaterIsNeededToo) {
  EXPECT_TRUE(others(false).find("a")->needed);
  EXPECT_FALSE(others(false).find("c")->needed);
  EXPECT_TRUE(others(true).find("c")->needed);
}

TEST(Peers, WhatTheyWantIsTakenOnceTheyAskForIt) {
  Peers peers = others();
  says(peers, "a", {spot(0)}, {spot(100)});
  says(peers, "c", {spot(200)}, {spot(300)}, 5);
  EXPECT_THAT(peers.others(), ElementsAre(spot(0), spot(100), spot(200), spot(300)));
  EXPECT_THAT(peers.taken(), ElementsAre(spot(0), spot(200), spot(300)));
  EXPECT_THAT(peers.taken({"a"}), ElementsAre(spot(0), spot(100), spot(200), spot(300)));
}

TEST(Peers, TheSlowestOfThoseWhoHaveNotAgreedSetsThePace) {
  Peers peers = others();
  EXPECT_EQ(peers.slowest(), Duration()) << "nothing is known of how long words take";
  for (const auto& [name, seconds] : std::map<std::string, double>{{"a", 1.5}, {"c", 0.5}}) {
    Exchange& exchange = peers.find(name)->exchange;
    Message answer;
    answer.number = 1;
    answer.known = exchange.tell({{spot(9)}, 0, {}, {}}, 7, MissionTime(), Duration()).version;
    exchange.hear(answer, MissionTime::seconds(seconds));
  }
  EXPECT_EQ(peers.slowest(), Duration::milliseconds(1'500));
  peers.find("a")->agreed = true;
  EXPECT_EQ(peers.slowest(), Duration::milliseconds(500));
  peers.find("c")->reachable = false;
  EXPECT_EQ(peers.slowest(), Duration());
}
TEST(Peers, WhoIsOutOfReachIsTakenToStayWhereItIs) {
  Peers peers = others();
  says(peers, "a", {spot(0)}, {spot(50), spot(100)});
  says(peers, "c", {spot(200), spot(210)}, {});
  EXPECT_THAT(peers.ends(), ElementsAre(spot(100), spot(210)));
  peers.find("a")->reachable = false;
  EXPECT_THAT(peers.ends(), ElementsAre(spot(0), spot(210)));
}

TEST(Peers, WhoHoldsMoreThanOnePlaceFlies) {
  Peers peers = others();
  says(peers, "a", {spot(0)}, {});
  says(peers, "c", {spot(200), spot(210)}, {});
  EXPECT_FALSE(peers.flies("a"));
  EXPECT_TRUE(peers.flies("c"));
  peers.find("c")->reachable = false;
  EXPECT_FALSE(peers.flies("c")) << "nobody knows";
  EXPECT_FALSE(peers.flies("d"));
}

TEST(Limits, OfTwoThatPressTheOneThatWaitsLongerGoesFirst) {
  const Limits limits;
  const MissionTime now = MissionTime::seconds(1'000);
  const auto since = [](double seconds) { return std::optional(MissionTime::seconds(seconds)); };
  EXPECT_FALSE(limits.longer(since(770), true, since(990), now)) << "it does not press yet";
  EXPECT_TRUE(limits.longer(since(750), false, since(990), now));
  EXPECT_TRUE(limits.longer(since(750), false, std::nullopt, now)) << "the other wants nothing";
  EXPECT_FALSE(limits.longer(std::nullopt, true, since(750), now));
  EXPECT_TRUE(limits.longer(since(700), false, since(750), now));
  EXPECT_FALSE(limits.longer(since(750), true, since(700), now));
}

TEST(Limits, WhereItIsNotClearTheEarlierOfTheRosterGoesFirst) {
  const Limits limits;
  const MissionTime now = MissionTime::seconds(1'000);
  const MissionTime one = MissionTime::seconds(700), other = MissionTime::seconds(704);
  for (const auto& [first, second] : {std::pair(one, other), std::pair(other, one)}) {
    EXPECT_TRUE(limits.longer(first, true, second, now));
    EXPECT_FALSE(limits.longer(first, false, second, now));
  }
}

TEST(Waits, WhoHasWaitedLongIsInTheWayThoughItNeedNotLeave) {
  const Waits waits{{{"a", Awaited::kToLeave},
                     {"b", Awaited::kToGoFirst},
                     {"c", Awaited::kToTell},
                     {"d", Awaited::kToBeAnswered}}};
  EXPECT_THAT(waits.to_leave(), ElementsAre("a"));
  EXPECT_THAT(waits.in_its_way(), ElementsAre("a", "b"));
  EXPECT_THAT(Waits().to_leave(), IsEmpty());
}

}  // namespace
}  // namespace skein::merging
