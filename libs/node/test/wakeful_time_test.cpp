// SPDX-License-Identifier: Apache-2.0
#include "skein/node/wakeful_time.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace skein::node {
namespace {

constexpr Duration ms(std::int64_t count) { return Duration::milliseconds(count); }

TEST(WakefulTime, IsSteadyTimeForWhoRunsWhenItIsDue) {
  WakefulTime time(ms(100));
  for (int i = 0; i < 100; ++i) time.run(ms(50 * i), ms(50 * i));
  EXPECT_EQ(time.at(ms(5000)), ms(5000));
}

TEST(WakefulTime, GoesOnWhileNothingIsDueAndNobodySpeaks) {
  WakefulTime time(ms(100));
  time.run(ms(0), std::nullopt);
  time.run(ms(60'000), ms(60'000));
  time.run(ms(90'000), std::nullopt);
  EXPECT_EQ(time.at(ms(90'000)), ms(90'000));
}

TEST(WakefulTime, ALittleLateIsNothing) {
  WakefulTime time(ms(100));
  time.run(ms(0), ms(50));
  time.run(ms(150), ms(50));
  EXPECT_EQ(time.at(ms(150)), ms(150));
}

TEST(WakefulTime, StandsStillWhileTheMachineHoldsTheNodeUp) {
  WakefulTime time(ms(100));
  time.run(ms(0), ms(50));
  time.run(ms(10'050), ms(50));
  EXPECT_EQ(time.at(ms(10'050)), ms(75));
  EXPECT_EQ(time.steady_at(ms(75)), ms(10'050));
  time.run(ms(10'100), ms(125));
  EXPECT_EQ(time.at(ms(10'100)), ms(125)) << "and goes on from there";
}

// What stays due for ever, or turns that each take longer than a period, must not stop it.
TEST(WakefulTime, GoesOnWithEachTurnOfANodeThatIsAlwaysLate) {
  WakefulTime time(ms(100));
  for (int i = 0; i <= 40; ++i) time.run(ms(1000 * i), ms(0));
  EXPECT_EQ(time.at(ms(40'000)), ms(1000));
}

RC_GTEST_PROP(WakefulTimeProperty, NeitherDecreasesNorOvertakesSteadyTime, ()) {
  WakefulTime time(ms(100));
  Duration steady, before;
  for (int i = 0; i < 50; ++i) {
    const Duration due = before + ms(*rc::gen::inRange(-300, 300));
    steady = steady + ms(*rc::gen::inRange(1, 700));
    const Duration gap = time.at(steady) - before;
    time.run(steady, due);
    const Duration own = time.at(steady);
    RC_ASSERT(own > before);
    RC_ASSERT(own <= steady);
    RC_ASSERT(own == before + gap || own == std::max(due, before) + ms(25));
    before = own;
  }
}

}  // namespace
}  // namespace skein::node
