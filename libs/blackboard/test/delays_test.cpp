// SPDX-License-Identifier: Apache-2.0
// What is on the air of a channel.
#include "delays.hpp"

#include <gtest/gtest.h>

#include "testing/samples.hpp"

namespace skein::blackboard {
namespace {

std::size_t arrived(Delays& delays, Duration now) {
  std::size_t count = 0;
  while (delays.take_due(now)) ++count;
  return count;
}

TEST(Delays, SamplesOfAChannelKeepTheirOrder) {
  Delays delays;
  delays.add(0, testing::telemetry(1), Duration::milliseconds(800), Duration::milliseconds(40));
  delays.add(0, testing::telemetry(2), Duration::milliseconds(100), Duration::milliseconds(40));
  delays.add(1, testing::telemetry(3), Duration::milliseconds(100), Duration::milliseconds(40));

  EXPECT_EQ(arrived(delays, Duration::milliseconds(140)), 1U) << "that of the other channel";
  EXPECT_EQ(arrived(delays, Duration::milliseconds(839)), 0U);
  EXPECT_EQ(arrived(delays, Duration::milliseconds(840)), 2U);
}

TEST(Delays, ACutTakesWhatIsStillBeingTransmitted) {
  Delays delays;
  delays.add(0, testing::telemetry(1), Duration::milliseconds(100), Duration::milliseconds(40));
  delays.add(0, testing::telemetry(2), Duration::milliseconds(300), Duration::milliseconds(40));
  delays.cut(0, Duration::milliseconds(120));

  EXPECT_EQ(arrived(delays, Duration::milliseconds(1'000)), 1U);
}

// Found by a random mission (--minds --capacity 19200 985005): a message came 0.7 s after the cut.
TEST(Delays, ACutTakesWhatWaitsBehindALongOneToo) {
  Delays delays;
  delays.add(0, testing::telemetry(1), Duration::milliseconds(800), Duration::milliseconds(40));
  delays.add(0, testing::telemetry(2), Duration::milliseconds(100), Duration::milliseconds(40));
  delays.cut(0, Duration::milliseconds(120));

  EXPECT_EQ(arrived(delays, Duration::milliseconds(1'000)), 0U);
}

}  // namespace
}  // namespace skein::blackboard
