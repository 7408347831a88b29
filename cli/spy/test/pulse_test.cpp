// SPDX-License-Identifier: Apache-2.0
#include "pulse.hpp"

#include <gtest/gtest.h>

namespace skein::spy_tool {
namespace {

Duration at(double seconds) { return Duration::seconds(seconds); }

TEST(Pulse, HasNoRateBeforeTheSecondBeat) {
  Pulse pulse(10);
  EXPECT_FALSE(pulse.intervals().has_value());
  EXPECT_FALSE(pulse.delays().has_value());
  pulse.beat(at(1), 100, 0);
  EXPECT_FALSE(pulse.intervals().has_value());
  EXPECT_EQ(pulse.bytes_per_second(), 0);
  EXPECT_EQ(pulse.sizes()->mean, 100);
}

TEST(Pulse, TellsMeanLeastGreatestAndDeviation) {
  Pulse pulse(10);
  for (const double when : {0.0, 1.0, 4.0}) pulse.beat(at(when), 10, when);
  const Spread between = *pulse.intervals();
  EXPECT_DOUBLE_EQ(between.mean, 2);
  EXPECT_DOUBLE_EQ(between.least, 1);
  EXPECT_DOUBLE_EQ(between.greatest, 3);
  EXPECT_DOUBLE_EQ(between.deviation, 1);
  EXPECT_DOUBLE_EQ(pulse.bytes_per_second(), 5);
}

TEST(Pulse, LooksBackOnItsWindowOnly) {
  Pulse pulse(3);
  for (int i = 0; i < 10; ++i) pulse.beat(at(i < 7 ? i : 100 + i), 10, 0);
  EXPECT_EQ(pulse.samples(), 3U);
  EXPECT_DOUBLE_EQ(pulse.intervals()->greatest, 1);
}

TEST(Pulse, OneOfAHundredMayBeLater) {
  Pulse pulse(1000);
  for (int i = 0; i < 100; ++i) pulse.beat(at(i), 1, i == 50 ? 9.0 : i == 51 ? 2.0 : 1.0);
  EXPECT_DOUBLE_EQ(pulse.delays()->late, 2);
  EXPECT_DOUBLE_EQ(pulse.delays()->greatest, 9);
}

}  // namespace
}  // namespace skein::spy_tool
