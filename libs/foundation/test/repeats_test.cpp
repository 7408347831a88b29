// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/repeats.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace skein {
namespace {

using ::testing::ElementsAre;

Duration secs(double s) { return Duration::seconds(s); }

TEST(Doubled, GrowsUpToTheMost) {
  std::vector<double> pauses;
  for (int times = 0; times < 6; ++times)
    pauses.push_back(doubled(secs(1), times, secs(20)).to_seconds());

  EXPECT_THAT(pauses, ElementsAre(1, 2, 4, 8, 16, 20));
}

TEST(Doubled, IsTheFirstWhereItWasNotDoubledYet) {
  EXPECT_EQ(doubled(secs(1), -7, secs(20)), secs(1));
  EXPECT_EQ(doubled(secs(20), 0, secs(20)), secs(20));
}

TEST(Doubled, EndsForAnyNumberOfTimes) {
  EXPECT_EQ(doubled(secs(1), 2'000'000'000, Duration::max()), Duration::max());
  EXPECT_EQ(doubled(Duration(), 2'000'000'000, Duration::max()), Duration());
}

TEST(DoubledDeath, WhatBeginsAboveTheMostIsABrokenContract) {
  EXPECT_DEATH(doubled(secs(21), 1, secs(20)), "precondition");
}

TEST(Repeats, ComeEverMoreRarely) {
  Repeats repeats{MissionTime::seconds(10), secs(1)};
  std::vector<double> done;
  for (double at = 10; at < 40; ++at) {
    const MissionTime now = MissionTime::seconds(at);
    if (!repeats.is_due(now)) continue;
    done.push_back(at);
    repeats.repeated(now, secs(8));
  }

  EXPECT_THAT(done, ElementsAre(11, 13, 17, 25, 33));
  EXPECT_EQ(repeats.due(), MissionTime::seconds(41));
}

}  // namespace
}  // namespace skein
