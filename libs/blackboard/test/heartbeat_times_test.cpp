// SPDX-License-Identifier: Apache-2.0
#include "heartbeat_times.hpp"

#include <gtest/gtest.h>

namespace skein::blackboard {
namespace {

constexpr Duration ms(std::int64_t count) { return Duration::milliseconds(count); }

TEST(HeartbeatTimes, TheFirstIsDueAtOnceAndTheNextALittleBeforeThePeriodIsOver) {
  HeartbeatTimes heartbeats(ms(200));
  EXPECT_TRUE(heartbeats.due({}));

  heartbeats.sent(ms(1000));

  EXPECT_EQ(heartbeats.next(), ms(1190));
  EXPECT_FALSE(heartbeats.due(ms(1189)));
  EXPECT_TRUE(heartbeats.due(ms(1190)));
}

TEST(HeartbeatTimes, AReasonMakesOneDueAtOnce) {
  HeartbeatTimes heartbeats(ms(200));
  heartbeats.sent(ms(1000));
  heartbeats.at_once(ms(1050));

  EXPECT_TRUE(heartbeats.due(ms(1050)));
  heartbeats.sent(ms(1050));
  EXPECT_EQ(heartbeats.next(), ms(1240));
}

TEST(HeartbeatTimes, AnAcknowledgementIsThereBeforeThePeriodIsOverAndIsOwedOnce) {
  HeartbeatTimes heartbeats(ms(200));
  heartbeats.sent(ms(1000));
  heartbeats.owe(ms(1010));
  heartbeats.owe(ms(1015));
  EXPECT_EQ(heartbeats.next(), ms(1010));

  heartbeats.sent(ms(1010));

  EXPECT_EQ(heartbeats.next(), ms(1200));
}

TEST(HeartbeatTimes, TheNextOneOfThePeriodDoesNotWaitForAnAcknowledgement) {
  HeartbeatTimes heartbeats(ms(200));
  heartbeats.sent(ms(1000));
  heartbeats.owe(ms(1500));

  EXPECT_EQ(heartbeats.next(), ms(1190));
}

}  // namespace
}  // namespace skein::blackboard
