// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <bit>
#include <cmath>

#include "skein/htn/number.hpp"

namespace skein::htn {
namespace {

TEST(NumberText, EveryFormOfLispIsRead) {
  const std::vector<std::pair<std::string, Number>> forms{
      {"12", integer(12)},
      {"-3", integer(-3)},
      {"+4", integer(4)},
      {"1.", integer(1)},
      {"1/3", {NumberKind::kRatio, 1, 3, 0}},
      {"-2/6", {NumberKind::kRatio, -1, 3, 0}},
      {"4/2", integer(2)},
      {".5", single(0.5)},
      {"-.5", single(-0.5)},
      {"0.01", single(0.01)},
      {"2e3", single(2000)},
      {"2E-3", single(0.002)},
      {"1.5s0", single(1.5)},
      {"1.5F+1", single(15)},
      {"0.01L0", real(0.01)},
      {"1d0", real(1)},
      {"1.e2", single(100)},
      {"-9223372036854775808", integer(INT64_MIN)},
  };

  for (const auto& [text, expected] : forms) {
    const auto parsed = parse_number(text);

    ASSERT_TRUE(parsed.has_value()) << text;
    ASSERT_TRUE(parsed->has_value()) << text;
    EXPECT_EQ(**parsed, expected) << text;
  }
}

TEST(NumberText, WhatIsNoNumberIsNone) {
  for (const char* text :
       {"",      "+",     "-",  ".",  "1+",  "1-",  "a",     "1a", "1/",  "/2",
        "1/2/3", "1.2.3", "e5", "1e", "1e+", "--1", "1/2.0", "?1", "1x0", "0x10"}) {
    EXPECT_FALSE(parse_number(text).has_value()) << text;
  }
}

TEST(NumberText, NumbersThatCannotBeRepresentedAreErrors) {
  for (const char* text :
       {"9223372036854775808", "1e39", "1d309", "1e-60", "1/0", "1/99999999999999999999"}) {
    const auto parsed = parse_number(text);

    ASSERT_TRUE(parsed.has_value()) << text;
    EXPECT_FALSE(parsed->has_value()) << text;
  }
}

TEST(NumberText, FloatsKeepTheirPointAndNamesNoPrecision) {
  EXPECT_EQ(to_text(single(4)), "4.0");
  EXPECT_EQ(to_text(real(7873.9600000000155)), "7873.9600000000155");
  EXPECT_EQ(to_text(real(1)), "1.0");
  EXPECT_EQ(to_text(single(21.050001)), "21.050001");
  EXPECT_EQ(to_text(single(0.01)), "0.01");
  EXPECT_EQ(to_text(single(-0.0)), "-0.0");
  EXPECT_EQ(to_text(single(9999999)), "9999999.0");
  EXPECT_EQ(to_text(single(0.001)), "0.001");
}

TEST(NumberText, LargeAndSmallFloatsHaveAnExponent) {
  EXPECT_EQ(to_text(single(1e7)), "1.0e7");
  EXPECT_EQ(to_text(single(1.5e-4)), "1.5e-4");
  EXPECT_EQ(to_text(real(-1.25e100)), "-1.25e100");
}

RC_GTEST_PROP(NumberText, ASingleReadsBackAsItself, (std::uint32_t bits)) {
  const auto value = std::bit_cast<float>(bits);
  RC_PRE(std::isfinite(value));
  const Number number = single(static_cast<double>(value));

  RC_ASSERT(**parse_number(to_text(number)) == number);
}

// Written plainly, a double is told from a single by what it is read as.
RC_GTEST_PROP(NumberText, ADoubleReadsBackAsItself, (std::uint64_t bits)) {
  const auto value = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(value));
  std::string text = to_text(real(value));
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) {
    text += "d0";
  } else {
    text[exponent] = 'd';
  }

  RC_ASSERT(**parse_number(text) == real(value));
}

RC_GTEST_PROP(NumberText, IntegersAndRatiosReadBackAsThemselves,
              (std::int64_t numerator, std::int32_t denominator)) {
  RC_PRE(denominator != 0);
  const auto ratio = divide(integer(numerator), integer(denominator));
  RC_PRE(ratio.has_value());

  RC_ASSERT(**parse_number(to_text(*ratio)) == *ratio);
}

RC_GTEST_PROP(NumberText, AnyTextIsANumberOrNone, (const std::string& noise)) {
  std::string text;
  for (const char letter : noise) {
    text += "0123456789+-./eEdLsx"[static_cast<unsigned char>(letter) % 20];
  }

  const auto parsed = parse_number(text);

  if (!parsed.has_value()) return;
  if (!parsed->has_value()) return;
  RC_ASSERT(parse_number(to_text(parsed->value())).has_value());
}

}  // namespace
}  // namespace skein::htn
