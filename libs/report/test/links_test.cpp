// SPDX-License-Identifier: Apache-2.0
#include "story/links.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "builders.hpp"

namespace skein::report {
namespace {

using testing::message;
using testing::stamp;

TEST(PairMessages, SentAndReceivedMeetBySlotChannelAndSequence) {
  const std::vector<Flight> flights = pair_messages(
      {message(1, "a", "b", 1, Direction::kSent), message(1.1, "a", "b", 2, Direction::kSent),
       message(1.5, "a", "b", 1, Direction::kReceived), message(1.6, "b", "a", 1, Direction::kSent),
       message(1.7, "a", "b", 1, Direction::kSent, "Other")});

  ASSERT_EQ(flights.size(), 4U);
  EXPECT_EQ(flights[0].sent, 1.0);
  EXPECT_EQ(flights[0].received, 1.5);
  EXPECT_EQ(flights[1].sequence, 2);
  EXPECT_FALSE(flights[1].received);
}

TEST(PairMessages, OfRepeatedRecordsTheEarliestCounts) {
  const std::vector<Flight> flights = pair_messages(
      {message(1, "a", "b", 1, Direction::kSent), message(4, "a", "b", 1, Direction::kSent),
       message(5, "a", "b", 1, Direction::kReceived),
       message(6, "a", "b", 1, Direction::kReceived)});

  ASSERT_EQ(flights.size(), 1U);
  EXPECT_EQ(flights[0].sent, 1.0);
  EXPECT_EQ(flights[0].received, 5.0);
}

TEST(PairMessages, OneThatWasOnlyReceivedIsKept) {
  const std::vector<Flight> flights =
      pair_messages({message(3, "a", "b", 1, Direction::kReceived)});

  ASSERT_EQ(flights.size(), 1U);
  EXPECT_FALSE(flights[0].sent);
}

SyncRecord sync(double at, Direction direction) { return {stamp(at), "551", "a", "b", direction}; }

TEST(PairSyncs, TheNthReceivedGoesWithTheNthSent) {
  const std::vector<Flight> flights =
      pair_syncs({sync(1, Direction::kSent), sync(2, Direction::kSent),
                  sync(3, Direction::kReceived), sync(4, Direction::kReceived)});

  ASSERT_EQ(flights.size(), 2U);
  EXPECT_EQ(flights[0].sent, 1.0);
  EXPECT_EQ(flights[0].received, 3.0);
  EXPECT_EQ(flights[1].received, 4.0);
}

TEST(PairSyncs, AReceptionLoggedBeforeItsSendingStillMeetsIt) {
  const std::vector<Flight> flights =
      pair_syncs({sync(1, Direction::kReceived), sync(1, Direction::kSent)});

  ASSERT_EQ(flights.size(), 1U);
  EXPECT_TRUE(flights[0].sent && flights[0].received);
}

TEST(TellLinks, BothDirectionsAreOnePair) {
  Journal j;
  j.links = {{stamp(0), "b", "a", true},
             {stamp(0), "a", "b", true},
             {stamp(4), "a", "b", false},
             {stamp(6), "a", "b", true}};

  const std::vector<LinkStory> links = tell_links(j, 10);

  ASSERT_EQ(links.size(), 1U);
  EXPECT_EQ(links[0].first, "a");
  EXPECT_EQ(links[0].up[0], (std::vector<Span>{{0, 4}, {6, 10}}));
  EXPECT_EQ(links[0].up[1], (std::vector<Span>{{0, 10}}));
  EXPECT_FALSE(links[0].belief[0]);
}

TEST(TellLinks, WhatANodeBelievesIsItsOwnDirection) {
  Journal j;
  j.reaches = {{stamp(1, "b"), "a", true}, {stamp(5, "b"), "a", false}};

  const std::vector<LinkStory> links = tell_links(j, 10);

  ASSERT_EQ(links.size(), 1U);
  EXPECT_TRUE(links[0].belief[1]);
  EXPECT_FALSE(links[0].belief[0]);
  EXPECT_EQ(links[0].believed[1], (std::vector<Span>{{1, 5}}));
}

TEST(TellLinks, APairWithoutRadioIsLeftOutWhereTheTruthIsTold) {
  Journal j;
  j.reaches = {{stamp(0, "a"), "sim", true}, {stamp(0, "a"), "b", true}};
  EXPECT_EQ(tell_links(j, 10).size(), 2U);

  j.links = {{stamp(0), "a", "b", true}};

  ASSERT_EQ(tell_links(j, 10).size(), 1U);
  EXPECT_EQ(tell_links(j, 10)[0].second, "b");
}

TEST(TellLinks, ANodesLinkToItselfIsNone) {
  Journal j;
  j.links = {{stamp(0), "a", "a", true}};
  j.reaches = {{stamp(0, "b"), "b", true}};

  EXPECT_TRUE(tell_links(j, 10).empty());
}

TEST(TellLinks, RepeatedStatesChangeNothing) {
  Journal j;
  j.links = {{stamp(0), "a", "b", false},
             {stamp(1), "a", "b", true},
             {stamp(2), "a", "b", true},
             {stamp(3), "a", "b", false},
             {stamp(4), "a", "b", false}};

  EXPECT_EQ(tell_links(j, 10).at(0).up[0], (std::vector<Span>{{1, 3}}));
}

TEST(TellLinks, WhatGoesPastRelaysIsASpanOfItsDirection) {
  Journal j;
  j.reaches = {{stamp(0), "b", true}};
  j.routes = {
      {stamp(2), "b", "c"}, {stamp(3), "b", "d"}, {stamp(5), "b", ""}, {stamp(8), "b", "c"}};

  const LinkStory link = tell_links(j, 10).at(0);

  EXPECT_EQ(link.relayed[1], (std::vector<Span>{{2, 5}, {8, 10}}));
  EXPECT_TRUE(link.relayed[0].empty());
}

TEST(Disagreement, IsTheTimeWhenExactlyOneHolds) {
  EXPECT_DOUBLE_EQ(disagreement({{0, 10}}, {{2, 12}}), 4);
  EXPECT_DOUBLE_EQ(disagreement({{0, 4}, {6, 10}}, {{0, 10}}), 2);
  EXPECT_DOUBLE_EQ(disagreement({}, {{0, 3}}), 3);
  EXPECT_DOUBLE_EQ(disagreement({}, {}), 0);
}

// Spans of whole seconds, against a count second by second.
RC_GTEST_PROP(Disagreement, AgreesWithACountSecondBySecond, ()) {
  const auto bits = rc::gen::container<std::vector<bool>>(30, rc::gen::arbitrary<bool>());
  const std::vector<bool> a = *bits, b = *bits;
  const auto spans = [](const std::vector<bool>& on) {
    std::vector<Span> result;
    for (std::size_t i = 0; i < on.size(); ++i) {
      const auto t = static_cast<double>(i);
      if (on[i] && (i == 0 || !on[i - 1])) result.push_back({t, t});
      if (on[i]) result.back().to = t + 1;
    }
    return result;
  };
  double expected = 0;
  for (std::size_t i = 0; i < a.size(); ++i) expected += a[i] != b[i] ? 1 : 0;

  RC_ASSERT(disagreement(spans(a), spans(b)) == expected);
}

}  // namespace
}  // namespace skein::report
