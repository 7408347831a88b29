// SPDX-License-Identifier: Apache-2.0
#include "text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace skein::report {
namespace {

TEST(ShortNumber, HasNoTrailingZerosAndNoNegativeZero) {
  EXPECT_EQ(short_number(12.0), "12");
  EXPECT_EQ(short_number(12.34, 1), "12.3");
  EXPECT_EQ(short_number(12.5, 3), "12.5");
  EXPECT_EQ(short_number(-0.01, 1), "0");
  EXPECT_EQ(short_number(100, 0), "100");
}

TEST(ShortNumber, WhatIsNotFiniteIsZero) {
  EXPECT_EQ(short_number(std::nan("")), "0");
  EXPECT_EQ(short_number(std::numeric_limits<double>::infinity()), "0");
}

TEST(FixedNumber, KeepsItsDecimals) {
  EXPECT_EQ(fixed_number(12.0, 1), "12.0");
  EXPECT_EQ(fixed_number(-0.001, 1), "0.0");
  EXPECT_EQ(fixed_number(std::nan(""), 1), "–");
}

TEST(Grouped, PutsThinSpacesBetweenThousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1\u202F000");
  EXPECT_EQ(grouped(1234567), "1\u202F234\u202F567");
}

TEST(ClockText, ShowsHoursOnlyWhenThereAreAny) {
  EXPECT_EQ(clock_text(0), "0:00");
  EXPECT_EQ(clock_text(65.9), "1:05");
  EXPECT_EQ(clock_text(3607), "1:00:07");
  EXPECT_EQ(clock_text(-10), "-0:10");
  EXPECT_EQ(clock_text(-0.4), "0:00");
  EXPECT_EQ(clock_text(std::nan("")), "–");
}

TEST(LengthText, ChoosesItsUnit) {
  EXPECT_EQ(length_text(3.14159), "3.1 m");
  EXPECT_EQ(length_text(850.2), "850 m");
  EXPECT_EQ(length_text(12345), "12.3 km");
}

TEST(SpanText, ChoosesItsUnit) {
  EXPECT_EQ(span_text(0.0021), "2.1 ms");
  EXPECT_EQ(span_text(0.035), "35 ms");
  EXPECT_EQ(span_text(4.24), "4.2 s");
  EXPECT_EQ(span_text(725), "12 min 05 s");
}

TEST(Shortened, CutsAtCharactersNotBytes) {
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("abcd", 3), "ab…");
  EXPECT_EQ(shortened("ãéîõ", 3), "ãé…");
  EXPECT_EQ(character_count("ãéî…"), 4U);
}

TEST(Counted, OneIsSingular) {
  EXPECT_EQ(counted(1, "link"), "1 link");
  EXPECT_EQ(counted(0, "link"), "0 links");
}

}  // namespace
}  // namespace skein::report
