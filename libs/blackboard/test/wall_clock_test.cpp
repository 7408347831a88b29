// SPDX-License-Identifier: Apache-2.0
#include "adapters/cyclonedds/wall_clock.hpp"

#include <gtest/gtest.h>

namespace skein::blackboard::cyclonedds {
namespace {

using namespace std::chrono_literals;

/// At this time after the first look, in which the wall clock went on by `by`.
bool set_back(WallClock& clock, std::chrono::milliseconds after, std::chrono::milliseconds by) {
  return clock.set_back(WallClock::Wall(1'000'000s + by), WallClock::Steady(50s + after));
}

TEST(AWallClock, ThatIsLookedAtForTheFirstTimeWasNotSetBack) {
  WallClock clock;
  EXPECT_FALSE(set_back(clock, 0ms, 0ms));
}

TEST(AWallClock, ThatWasSetBackIsSoOnce) {
  WallClock clock;
  set_back(clock, 0ms, 0ms);
  EXPECT_FALSE(set_back(clock, 1s, 1s));
  EXPECT_TRUE(set_back(clock, 2s, 2s - 24h));
  EXPECT_FALSE(set_back(clock, 3s, 3s - 24h));
}

TEST(AWallClock, ThatWasSetForwardWasNotSetBackUntilItIsAgain) {
  WallClock clock;
  set_back(clock, 0ms, 0ms);
  EXPECT_FALSE(set_back(clock, 1s, 1s + 24h));
  EXPECT_TRUE(set_back(clock, 2s, 2s));
}

TEST(AWallClock, ThatIsCorrectedSlowlyWasNotSetBack) {
  WallClock clock;
  set_back(clock, 0ms, 0ms);
  for (int minute = 1; minute <= 10; ++minute)
    EXPECT_FALSE(set_back(clock, minute * 60s, minute * (60s - 20ms))) << minute;
}

}  // namespace
}  // namespace skein::blackboard::cyclonedds
