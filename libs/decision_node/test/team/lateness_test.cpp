// SPDX-License-Identifier: Apache-2.0
#include "team/lateness.hpp"

#include <gtest/gtest.h>

namespace skein::decision_node {
namespace {

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

// Its first plan is made at 0 s: it ends from 50 s on, by 60 s.
Lateness planned() {
  Lateness lateness;
  lateness.planned(at(50), at(60));
  return lateness;
}

TEST(Lateness, WithoutAPlanNothingIsPromised) {
  EXPECT_EQ(Lateness().behind(at(1000)), std::nullopt);
  EXPECT_EQ(Lateness().due(), std::nullopt);
}

TEST(Lateness, WhatHasNoLatestEndIsNeverLate) {
  Lateness lateness;
  lateness.planned(at(50), MissionTime::max());
  EXPECT_EQ(lateness.behind(at(1000)), std::nullopt);
}

TEST(Lateness, ItIsBehindOnceTheMarginBeyondTheLatestEndIsOver) {
  EXPECT_EQ(planned().behind(at(79.9)), std::nullopt);
  EXPECT_EQ(planned().behind(at(80)), Duration::seconds(20.0));
  EXPECT_EQ(planned().due(), at(80));
}

TEST(Lateness, APlanThatCannotEndInTimeIsBehindAtOnce) {
  Lateness lateness = planned();
  lateness.planned(at(95), at(110));
  EXPECT_EQ(lateness.behind(at(10)), Duration::seconds(35.0));
}

TEST(Lateness, LaterPlansPromiseNothing) {
  Lateness lateness = planned();
  lateness.planned(at(70), at(200));
  EXPECT_EQ(lateness.due(), at(80));
}

TEST(Lateness, OnceToldItCountsFromThePresentPlanWithTwiceTheMargin) {
  Lateness lateness = planned();
  lateness.planned(at(95), at(110));
  lateness.renew(at(10));

  EXPECT_EQ(lateness.behind(at(149)), std::nullopt);
  EXPECT_EQ(lateness.due(), at(150));
  lateness.renew(at(150));
  EXPECT_EQ(lateness.due(), at(230)) << "four times";
}

TEST(Lateness, AnotherTaskHasAnotherPromise) {
  Lateness lateness = planned();
  lateness.renew(at(80));
  lateness.begun();
  EXPECT_EQ(lateness.due(), std::nullopt);
  lateness.planned(at(150), at(160));
  EXPECT_EQ(lateness.due(), at(180));
}

}  // namespace
}  // namespace skein::decision_node
