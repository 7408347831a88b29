// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/time.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "skein/foundation/rounded_seconds.hpp"

namespace skein {
namespace {

TEST(Duration, RoundsSecondsToTheNearestNanosecond) {
  EXPECT_EQ(Duration::seconds(0.1).count(), 100'000'000);
  EXPECT_EQ(Duration::seconds(-1.5).count(), -1'500'000'000);
  EXPECT_EQ(Duration::seconds(4e-10).count(), 0);
  EXPECT_EQ(Duration::seconds(6e-10).count(), 1);
}

TEST(Duration, OutOfRangeSecondsSaturate) {
  EXPECT_EQ(Duration::seconds(1e300), Duration::max());
  EXPECT_EQ(Duration::seconds(-1e300).count(), std::numeric_limits<std::int64_t>::min());
}

TEST(Duration, OutOfRangeMillisecondsSaturate) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  static_assert(Duration::milliseconds(kMost / 1'000'000).count() == 9'223'372'036'854'000'000);
  static_assert(Duration::milliseconds(kMost / 1'000'000 + 1) == Duration::max());
  EXPECT_EQ(Duration::milliseconds(kMost), Duration::max());
  EXPECT_EQ(Duration::milliseconds(-kMost).count(), std::numeric_limits<std::int64_t>::min());
}

TEST(Duration, NotANumberIsABrokenContract) {
  EXPECT_DEATH((void)Duration::seconds(std::numeric_limits<double>::quiet_NaN()), "precondition");
}

TEST(MissionTime, ForEverStaysForEver) {
  EXPECT_EQ(MissionTime::max() + Duration::seconds(1), MissionTime::max());
  EXPECT_EQ(MissionTime::max() - Duration::nanoseconds(-1), MissionTime::max());
  const auto first = MissionTime::nanoseconds(std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(first - Duration::seconds(1), first);
}

TEST(MissionTime, DifferenceOfTwoInstantsIsADuration) {
  EXPECT_EQ(MissionTime::seconds(5) - MissionTime::seconds(7), Duration::seconds(-2));
}

TEST(MissionTime, TextIsExactToTheNanosecond) {
  EXPECT_EQ(to_text(MissionTime::nanoseconds(12'500'000'000)), "12.5");
  EXPECT_EQ(to_text(MissionTime::nanoseconds(-1)), "-0.000000001");
  EXPECT_EQ(to_text(MissionTime::nanoseconds(0)), "0");
  EXPECT_EQ(to_text(Duration::nanoseconds(std::numeric_limits<std::int64_t>::min())),
            "-9223372036.854775808");
}

TEST(MissionTime, ClockTextIsForPeople) {
  EXPECT_EQ(to_clock_text(MissionTime::seconds(3725.9)), "1:02:05");
  EXPECT_EQ(to_clock_text(MissionTime::seconds(-1)), "-0:00:01");
}

TEST(MissionTime, EarliestIgnoresWhatNeverComes) {
  EXPECT_EQ(earliest(std::nullopt, std::nullopt), std::nullopt);
  EXPECT_EQ(earliest(MissionTime::seconds(1), std::nullopt), MissionTime::seconds(1));
  EXPECT_EQ(earliest(MissionTime::seconds(2), MissionTime::seconds(1)), MissionTime::seconds(1));
}

TEST(InSeconds, RoundsToATenthForPeople) {
  EXPECT_EQ(in_seconds(MissionTime::nanoseconds(163'829'833'988)), "163.8 s");
  EXPECT_EQ(in_seconds(Duration::milliseconds(-250)), "-0.3 s");
  EXPECT_EQ(in_seconds(MissionTime::seconds(300)), "300 s");
  EXPECT_EQ(in_seconds(Duration::max()), "for ever");
  EXPECT_EQ(in_seconds(Duration::max() - Duration::seconds(1)), "9223372035.9 s");
  EXPECT_EQ(in_seconds(Duration::nanoseconds(std::numeric_limits<std::int64_t>::min())),
            "-9223372036.854775808 s")
      << "to a tenth it would be beyond the range";
}

}  // namespace
}  // namespace skein
