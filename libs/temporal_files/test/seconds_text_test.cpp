// SPDX-License-Identifier: Apache-2.0
#include "seconds_text.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

namespace skein::temporal {
namespace {

Result<Ticks, BadSeconds> strict(std::string_view text) {
  return seconds_from(text, BelowNanosecond::kRefuse);
}

Ticks rounded(std::string_view text) {
  return seconds_from(text, BelowNanosecond::kRound).value_or(-999);
}

TEST(SecondsText, ReadsDecimalsExactly) {
  EXPECT_EQ(strict("0"), 0);
  EXPECT_EQ(strict("-0.0"), 0);
  EXPECT_EQ(strict("12.5"), 12'500'000'000);
  EXPECT_EQ(strict("+3"), 3'000'000'000);
  EXPECT_EQ(strict("-.000000001"), -1);
  EXPECT_EQ(strict("1."), 1'000'000'000);
  EXPECT_EQ(strict("1e-9"), 1);
  EXPECT_EQ(strict("0.0125E+3"), 12'500'000'000);
  EXPECT_EQ(strict("1.100000000000000000000"), 1'100'000'000);
  EXPECT_EQ(strict("0e999999999999999999999"), 0);
}

TEST(SecondsText, KeepsNanosecondsThatADoubleLoses) {
  EXPECT_EQ(strict("1152921504.606846975"), kLargest - 1);
  EXPECT_EQ(strict("1152921504.606846976"), kLargest);
  EXPECT_EQ(strict("-1152921504.606846976"), -kLargest);
}

TEST(SecondsText, RefusesWhatOverflows) {
  for (const char* text : {"1152921504.606846977", "1e10", "-1e400", "99999999999999999999",
                           "1e99999999999999999999"}) {
    EXPECT_EQ(strict(text), tl::unexpected(BadSeconds::kOverflow)) << text;
  }
}

TEST(SecondsText, RefusesWhatIsNoNumber) {
  for (const char* text : {"", "-", ".", "e5", "1e", "1e+", "nan", "inf", "0x10", "1 ", " 1", "1,5",
                           "1.2.3", "--1", "1e2.5"}) {
    EXPECT_EQ(strict(text), tl::unexpected(BadSeconds::kNotANumber)) << text;
  }
}

TEST(SecondsText, RefusesOrRoundsWhatIsFinerThanANanosecond) {
  EXPECT_EQ(strict("0.0000000001"), tl::unexpected(BadSeconds::kTooFine));
  EXPECT_EQ(strict("1e-99999999999999"), tl::unexpected(BadSeconds::kTooFine));

  EXPECT_EQ(rounded("0.0000000004"), 0);
  EXPECT_EQ(rounded("0.0000000005"), 1);
  EXPECT_EQ(rounded("-0.0000000015"), -2);
  EXPECT_EQ(rounded("0.30000000000000004"), 300'000'000);
  EXPECT_EQ(rounded("1e-99999999999999"), 0);
  EXPECT_EQ(rounded("0.9999999999"), kTicksPerSecond);
}

RC_GTEST_PROP(SecondsText, WritesWhatItReadsBack, ()) {
  const Ticks ticks = *rc::gen::inRange<Ticks>(-kLargest, kLargest + 1);

  RC_ASSERT(strict(seconds_text(ticks)) == ticks);
}

}  // namespace
}  // namespace skein::temporal
