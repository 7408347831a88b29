// SPDX-License-Identifier: Apache-2.0
#include "skein/htn/number.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>
#include <limits>
#include <numeric>

namespace skein::htn {
namespace {

constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kSmallest = std::numeric_limits<std::int64_t>::min();

Number number(const std::string& text) { return parse_number(text).value().value(); }

std::string text(const Result<Number, Failure>& result) {
  return result ? to_text(*result) : "error: " + result.error().why;
}

float as_float(const Number& value) { return static_cast<float>(value.real); }

TEST(Number, TheWiderKindOfBothIsTheKindOfTheResult) {
  EXPECT_EQ(add(number("1"), number("2"))->kind, NumberKind::kInteger);
  EXPECT_EQ(add(number("1"), number("1/2"))->kind, NumberKind::kRatio);
  EXPECT_EQ(add(number("1/2"), number("0.5"))->kind, NumberKind::kSingle);
  EXPECT_EQ(add(number("0.5"), number("0.5d0"))->kind, NumberKind::kDouble);
  EXPECT_EQ(multiply(number("0"), number("0.5"))->kind, NumberKind::kSingle);
}

TEST(Number, SumsOfSingleFloatsAreMadeInSinglePrecision) {
  const auto first = add(number("1.01"), number("3"));

  EXPECT_EQ(text(add(*first, number("0.01"))), "4.0200005");
}

TEST(Number, SumsWithALongFloatAreMadeInDoublePrecision) {
  EXPECT_EQ(text(add(number("0.01L0"), number("7134"))), "7134.01");
}

TEST(Number, QuotientsOfIntegersAreRatiosInLowestTerms) {
  EXPECT_EQ(text(divide(integer(4), integer(-6))), "-2/3");
  EXPECT_EQ(text(divide(integer(6), integer(3))), "2");
  EXPECT_EQ(text(divide(number("2/3"), number("4/3"))), "1/2");
}

TEST(Number, DivisionByZeroIsAnError) {
  for (const char* zero : {"0", "0.0", "-0.0", "0d0"}) {
    EXPECT_EQ(text(divide(number("1"), number(zero))), "error: division by zero") << zero;
  }
}

TEST(Number, IntegersBeyond64BitsAreErrors) {
  EXPECT_FALSE(add(integer(kLargest), integer(1)));
  EXPECT_FALSE(subtract(integer(kSmallest), integer(1)));
  EXPECT_FALSE(multiply(integer(kLargest), integer(2)));
  EXPECT_FALSE(divide(integer(kSmallest), integer(-1)));
  EXPECT_EQ(text(add(integer(kLargest), integer(kSmallest))), "-1");
}

TEST(Number, RatiosOfExtremeIntegersAreExactOrErrors) {
  const auto tiny = divide(integer(1), integer(kLargest));

  ASSERT_TRUE(tiny);
  EXPECT_EQ(text(multiply(*tiny, integer(kLargest))), "1");
  EXPECT_FALSE(multiply(*tiny, *tiny));
  EXPECT_FALSE(divide(integer(1), integer(kSmallest)));
}

TEST(Number, FloatsBeyondTheirRangeAreErrors) {
  EXPECT_FALSE(multiply(number("1e38"), number("10")));
  EXPECT_FALSE(multiply(number("1d308"), number("10")));
  EXPECT_TRUE(multiply(number("1d38"), number("10")));
}

TEST(Number, ComparisonsAreExactWhateverTheKinds) {
  EXPECT_TRUE(equal_value(number("1/2"), number("0.5")));
  EXPECT_FALSE(equal_value(number("1/10"), number("0.1d0")));
  EXPECT_FALSE(equal_value(number("0.1"), number("0.1d0")));
  EXPECT_TRUE(less_value(number("0.1d0"), number("0.1")));
  EXPECT_TRUE(less_value(number("1/3"), number("0.3333334")));
  EXPECT_TRUE(less_value(number("9007199254740992.0d0"), number("9007199254740993")));
  EXPECT_TRUE(less_value(integer(kLargest), number("9223372036854775808.0d0")));
  EXPECT_TRUE(equal_value(integer(kSmallest), number("-9223372036854775808.0d0")));
  EXPECT_TRUE(less_value(number("-1d300"), integer(kSmallest)));
}

RC_GTEST_PROP(Number, SumsAndProductsOfIntegersAreThoseOfTheMachine,
              (std::int32_t left, std::int32_t right)) {
  const std::int64_t wide_left = left;
  const std::int64_t wide_right = right;

  RC_ASSERT(add(integer(left), integer(right)) == integer(wide_left + wide_right));
  RC_ASSERT(subtract(integer(left), integer(right)) == integer(wide_left - wide_right));
  RC_ASSERT(multiply(integer(left), integer(right)) == integer(wide_left * wide_right));
}

RC_GTEST_PROP(Number, OverflowIsFoundExactlyWhereTheMachineFindsIt,
              (std::int64_t left, std::int64_t right)) {
  std::int64_t sum = 0;
  std::int64_t product = 0;

  RC_ASSERT(add(integer(left), integer(right)).has_value() ==
            !__builtin_add_overflow(left, right, &sum));
  RC_ASSERT(multiply(integer(left), integer(right)).has_value() ==
            !__builtin_mul_overflow(left, right, &product));
}

RC_GTEST_PROP(Number, ArithmeticOfSinglesIsThatOfFloats, (float left, float right)) {
  RC_PRE(std::isfinite(left) && std::isfinite(right) && right != 0);
  const Number first = single(static_cast<double>(left));
  const Number second = single(static_cast<double>(right));
  const auto same = [](const Result<Number, Failure>& result, float expected) {
    return result ? as_float(*result) == expected : !std::isfinite(expected);
  };

  RC_ASSERT(same(add(first, second), left + right));
  RC_ASSERT(same(subtract(first, second), left - right));
  RC_ASSERT(same(multiply(first, second), left * right));
  RC_ASSERT(same(divide(first, second), left / right));
}

RC_GTEST_PROP(Number, ArithmeticOfDoublesIsThatOfDoubles, (double left, double right)) {
  RC_PRE(std::isfinite(left) && std::isfinite(right) && right != 0);
  const auto same = [](const Result<Number, Failure>& result, double expected) {
    return result ? result->real == expected : !std::isfinite(expected);
  };

  RC_ASSERT(same(add(real(left), real(right)), left + right));
  RC_ASSERT(same(divide(real(left), real(right)), left / right));
}

RC_GTEST_PROP(Number, AnIntegerCombinedWithASingleBecomesOne, (std::int32_t left, float right)) {
  RC_PRE(std::isfinite(right));

  const auto sum = add(integer(left), single(static_cast<double>(right)));

  RC_ASSERT(!sum || as_float(*sum) == static_cast<float>(left) + right);
}

RC_GTEST_PROP(Number, RatiosAreKeptInLowestTerms, (std::int32_t numerator, std::int32_t below)) {
  RC_PRE(below != 0);

  const auto ratio = divide(integer(numerator), integer(below));

  RC_ASSERT(ratio.has_value());
  RC_ASSERT(std::gcd(ratio->numerator, ratio->denominator) == 1 || ratio->numerator == 0);
  RC_ASSERT(ratio->denominator > 0);
  RC_ASSERT(multiply(*ratio, integer(below)) == integer(numerator));
}

RC_GTEST_PROP(Number, ComparisonsWithDoublesAgreeWithLongDoubles,
              (std::int64_t left, double right)) {
  RC_PRE(std::isfinite(right));
  const auto exact = static_cast<long double>(left);  // 64 bits of mantissa
  const auto other = static_cast<long double>(right);

  RC_ASSERT(less_value(integer(left), real(right)) == (exact < other));
  RC_ASSERT(less_value(real(right), integer(left)) == (other < exact));
  RC_ASSERT(equal_value(integer(left), real(right)) == (exact == other));
}

RC_GTEST_PROP(Number, OfTwoNumbersOneIsLessOrTheyAreEqual,
              (std::int16_t first, std::uint8_t second, float third)) {
  RC_PRE(std::isfinite(third));
  const Number ratio = divide(integer(first), integer(second + 1)).value();
  const Number inexact = single(static_cast<double>(third));

  const int cases = (less_value(ratio, inexact) ? 1 : 0) + (less_value(inexact, ratio) ? 1 : 0) +
                    (equal_value(ratio, inexact) ? 1 : 0);

  RC_ASSERT(cases == 1);
}

}  // namespace
}  // namespace skein::htn
