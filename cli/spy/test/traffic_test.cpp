// SPDX-License-Identifier: Apache-2.0
#include "traffic.hpp"

#include <gtest/gtest.h>

namespace skein::spy_tool {
namespace {

Duration at(double seconds) { return Duration::seconds(seconds); }

TEST(Traffic, CountsPerSlotOriginAndDestination) {
  Traffic traffic;

  traffic.count(wire::Slot::kTelemetry, 10, 1, false, at(0));
  traffic.count(wire::Slot::kTelemetry, 10, 1, false, at(1));
  traffic.count(wire::Slot::kTelemetry, 11, 1, false, at(1));
  traffic.count(wire::Slot::kClock, 2, 0, false, at(1));

  const auto flows = traffic.flows();
  ASSERT_EQ(flows.size(), 3U);
  EXPECT_EQ(flows[0].slot, wire::Slot::kClock);
  EXPECT_EQ(flows[1].origin, 10U);
  EXPECT_EQ(flows[1].samples, 2U);
}

TEST(Traffic, RateIsBetweenTheFirstAndTheLast) {
  Traffic traffic;
  for (int i = 0; i <= 10; ++i) {
    traffic.count(wire::Slot::kClock, 2, 0, false, at(0.2 * i));
  }

  EXPECT_NEAR(traffic.flows()[0].rate(), 5, 1e-9);
}

TEST(Traffic, AHistoryInOneBurstHasNoRate) {
  Traffic traffic;
  for (int i = 0; i < 10; ++i) {
    traffic.count(wire::Slot::kTaskEvent, 10, 1, false, at(1 + 1e-5 * i));
  }

  EXPECT_EQ(traffic.flows()[0].rate(), 0);
  EXPECT_EQ(traffic.flows()[0].samples, 10U);
}

TEST(Traffic, MalformedSamplesAreCountedApart) {
  Traffic traffic;

  traffic.count(wire::Slot::kAlarm, 1, 0, true, at(0));
  traffic.count(wire::Slot::kAlarm, 1, 0, false, at(1));

  EXPECT_EQ(traffic.flows()[0].malformed, 1U);
  EXPECT_EQ(traffic.flows()[0].samples, 1U);
}

}  // namespace
}  // namespace skein::spy_tool
