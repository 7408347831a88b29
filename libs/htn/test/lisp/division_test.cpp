// SPDX-License-Identifier: Apache-2.0
// Quotients, remainders and powers over the whole range of integers, against wider arithmetic; and
// where floats come in.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "terms/wide_integer.hpp"
#include "testing/lisp_fixture.hpp"

namespace skein::htn {
namespace {

using Cases = std::vector<std::pair<std::string, std::string>>;
using Limits64 = std::numeric_limits<std::int64_t>;

const char* const kBeyond = "the result is an integer beyond 64 bits";

class LispDivision : public ::testing::Test, protected test::LispFixture {
 protected:
  void expect(const Cases& cases) {
    for (const auto& [text, expected] : cases) EXPECT_EQ(value(text), expected) << text;
  }
};

/// Near a power of two or an end of the range more often than not.
std::int64_t drawn_integer() {
  const auto any = *rc::gen::arbitrary<std::int64_t>();
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return any;
    case 1:
      return Limits64::max() - std::abs(any % 4);
    case 2:
      return Limits64::min() + std::abs(any % 4);
    default:
      return any % 20;
  }
}

WideInteger floor_of(WideInteger number, WideInteger divisor) {
  const WideInteger whole = number / divisor;
  const bool below = number % divisor != 0 && (number < 0) != (divisor < 0);
  return below ? whole - 1 : whole;
}

WideInteger nearest_of(WideInteger number, WideInteger divisor) {
  const WideInteger below = floor_of(number, divisor);
  const WideInteger twice = 2 * (number - below * divisor);  // against the divisor: over or under
  const WideInteger over = divisor < 0 ? divisor - twice : twice - divisor;
  return over > 0 || (over == 0 && below % 2 != 0) ? below + 1 : below;
}

std::string answer(const std::string& function, WideInteger value) {
  return fits_64_bits(value) ? std::to_string(static_cast<std::int64_t>(value))
                             : "error: '" + function + "': " + kBeyond;
}

RC_GTEST_PROP(LispDivisionProperty, QuotientsAndRestsAreThoseOfWiderIntegers, ()) {
  const std::int64_t number = drawn_integer();
  const std::int64_t divisor = drawn_integer();
  RC_PRE(divisor != 0);
  test::LispFixture lisp;
  const WideInteger n = number, d = divisor;
  const WideInteger floor = floor_of(n, d);
  const WideInteger ceiling = -floor_of(-n, d);
  const std::vector<std::pair<std::string, WideInteger>> cases{
      {"floor", floor},       {"ceiling", ceiling},
      {"truncate", n / d},    {"round", nearest_of(n, d)},
      {"mod", n - floor * d}, {"rem", n % d}};

  for (const auto& [function, expected] : cases) {
    const std::string text =
        "(" + function + " " + std::to_string(number) + " " + std::to_string(divisor) + ")";
    RC_LOG() << text;
    RC_ASSERT(lisp.value(text) == answer(function, expected));
  }
}

RC_GTEST_PROP(LispDivisionProperty, AnIntegerIsItsOwnQuotient, ()) {
  const std::string number = std::to_string(drawn_integer());
  test::LispFixture lisp;

  for (const char* const function : {"floor", "ceiling", "truncate", "round"})
    RC_ASSERT(lisp.value("(" + std::string(function) + " " + number + ")") == number);
}

RC_GTEST_PROP(LispDivisionProperty, PowersAreRepeatedProducts, ()) {
  const auto base = *rc::gen::inRange(-12, 13);
  const auto power = *rc::gen::inRange(0, 40);
  WideInteger expected = 1;
  for (int i = 0; i < power && fits_64_bits(expected); ++i) expected *= base;
  const std::string text = std::to_string(base) + " " + std::to_string(power);
  test::LispFixture lisp;

  RC_ASSERT(lisp.value("(expt " + text + ")") == answer("expt", expected));
}

TEST_F(LispDivision, RestsExistWhereTheirQuotientTimesTheDivisorWouldNot) {
  expect({{"(mod -9223372036854775808 9223372036854775807)", "9223372036854775806"},
          {"(mod 9223372036854775807 -9223372036854775808)", "-1"},
          {"(rem -9223372036854775808 9223372036854775807)", "-1"},
          {"(rem -9223372036854775808 -1)", "0"},
          {"(mod 5 -9223372036854775808)", "-9223372036854775803"}});
}

TEST_F(LispDivision, RatiosHaveRestsOfTheirOwnKind) {
  expect({{"(mod -7/2 3)", "5/2"},
          {"(rem -7/2 3)", "-1/2"},
          {"(mod 7 2/3)", "1/3"},
          {"(mod 2 2/3)", "0"},
          {"(mod 7/2 -3/4)", "-1/4"},
          {"(rem 7/2 -3/4)", "1/2"}});
}

TEST_F(LispDivision, FloatsHaveRestsOfTheSignThatIsAskedFor) {
  expect({{"(mod 5.5 -2)", "-0.5"},
          {"(rem 5.5 -2)", "1.5"},
          {"(mod -6.0 3)", "-0.0"},
          {"(mod 7 2.5d0)", "2.0"},
          {"(floatp (mod 7 2.5d0))", "t"},
          {"(mod 1.5 0.0)", "error: 'mod': division by zero"},
          {"(rem 1/2 0)", "error: 'rem': division by zero"}});
}

TEST_F(LispDivision, EachArgumentMustBeANumber) {
  for (const char* const function : {"floor", "ceiling", "truncate", "round", "mod", "rem"}) {
    const std::string name = function;
    EXPECT_EQ(value("(" + name + " 'a 2)"),
              "error: '" + name + "': argument 1 is the symbol a, expected a number");
    EXPECT_EQ(value("(" + name + " 2 'b)"),
              "error: '" + name + "': argument 2 is the symbol b, expected a number");
  }
}

TEST_F(LispDivision, FloatsBecomeIntegersOnlyWhereTheyFit) {
  expect({{"(floor 9223372036854774784d0)", "9223372036854774784"},
          {"(floor 9223372036854775808d0)", "error: 'floor': " + std::string(kBeyond)},
          {"(truncate -9223372036854775808d0)", "-9223372036854775808"},
          {"(truncate -9223372036854777856d0)", "error: 'truncate': " + std::string(kBeyond)},
          {"(round 1.5d0 0.5d0)", "3"},
          {"(round -1.5)", "-2"},
          {"(round -2.5)", "-2"},
          {"(ceiling -0.5)", "0"}});
}

// CLHS, EXPT: with the power 0 the result is always 1 in the type of the base.
TEST_F(LispDivision, APowerOfZeroIsOneOfTheKindOfItsBase) {
  expect({{"(expt 2.0 0)", "1.0"},
          {"(eql (expt 2.0 0) 1.0)", "t"},
          {"(eql (expt 2d0 0) 1d0)", "t"},
          {"(expt 0.0 0)", "1.0"},
          {"(expt 2/3 0)", "1"}});
}

TEST_F(LispDivision, PowersOfFloatsStayFloatsOrAreErrors) {
  expect({{"(expt 2.0 3)", "8.0"},
          {"(expt 2.0 -2)", "0.25"},
          {"(expt 0.0 -1)", "error: 'expt': division by zero"},
          {"(expt 9 0.5d0)", "3.0"},
          {"(expt 'a 2)", "error: 'expt': argument 1 is the symbol a, expected a number"},
          {"(expt 2 'b)", "error: 'expt': argument 2 is the symbol b, expected a number"},
          {"(expt 1e30 2)", "error: 'expt': the result is a float beyond its range"}});
}

TEST_F(LispDivision, ANumberBecomesAFloatOfThePrecisionOfASecond) {
  expect({{"(float 1/4 0.0)", "0.25"},
          {"(eql (float 1/4 0d0) 0.25d0)", "t"},
          {"(eql (float 0.25d0 0.0) 0.25)", "t"},
          {"(eql (float 0.25d0) 0.25d0)", "t"},
          {"(float 1d300 1.0)", "error: 'float': a float beyond its range"},
          {"(float 'a)", "error: 'float': argument 1 is the symbol a, expected a number"},
          {"(float 1 'a)", "error: 'float': argument 2 is the symbol a, expected a number"}});
}

TEST_F(LispDivision, RootsHaveThePrecisionOfTheirArgument) {
  expect({{"(eql (sqrt 4) 2.0)", "t"},
          {"(eql (sqrt 4d0) 2d0)", "t"},
          {"(sqrt 1/4)", "0.5"},
          {"(sqrt 0)", "0.0"},
          {"(sqrt -1/4)",
           "error: 'sqrt': argument 1 is -1/4, expected a number that is not "
           "negative"},
          {"(sqrt 'a)",
           "error: 'sqrt': argument 1 is the symbol a, expected a number that is not "
           "negative"}});
}

}  // namespace
}  // namespace skein::htn
