// SPDX-License-Identifier: Apache-2.0
#include "skein/node/heartbeat.hpp"

#include <gtest/gtest.h>

namespace skein::node {
namespace {

TEST(SteadyHeartbeat, IsTheMissionsPeriodDividedByTheRate) {
  EXPECT_EQ(steady_heartbeat(Duration::seconds(1), 1), Duration::milliseconds(1000));
  EXPECT_EQ(steady_heartbeat(Duration::seconds(1), 0.5), Duration::milliseconds(2000));
  EXPECT_EQ(steady_heartbeat(Duration::seconds(2), 4), Duration::milliseconds(500));
}

TEST(SteadyHeartbeat, IsNeverShorterThanABusyMachineStandsStill) {
  EXPECT_EQ(steady_heartbeat(Duration::seconds(1), 10), kLeastSteadyHeartbeat);
  EXPECT_EQ(steady_heartbeat(Duration::seconds(1), 1000), kLeastSteadyHeartbeat);
}

}  // namespace
}  // namespace skein::node
