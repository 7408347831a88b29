// SPDX-License-Identifier: Apache-2.0
// Integers, ratios, single and double floats, mixed: results against fractions of wide integers and
// the floats of C++.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <variant>

#include "terms/wide_integer.hpp"
#include "testing/lisp_fixture.hpp"

namespace skein::htn::tower {
namespace {

/// In lowest terms; below is positive.
struct Fraction {
  WideInteger above = 0, below = 1;
};

Fraction fraction(WideInteger above, WideInteger below) {
  WideInteger a = above < 0 ? -above : above, b = below < 0 ? -below : below;
  while (b != 0) {
    const WideInteger rest = a % b;
    a = b;
    b = rest;
  }
  if (below < 0) a = -a;
  return {above / a, below / a};
}

/// What a float is, exactly; of those drawn here the parts are short enough.
Fraction exactly(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  auto above = static_cast<WideInteger>(std::ldexp(mantissa, 53));
  WideInteger below = 1;
  for (exponent -= 53; exponent < 0 && above % 2 == 0; ++exponent) above /= 2;
  for (; exponent < 0; ++exponent) below *= 2;
  for (; exponent > 0; --exponent) above *= 2;
  return fraction(above, below);
}

using Number = std::variant<Fraction, float, double>;

struct Written {
  Number number;
  std::string text;
};

std::string text_of(const Fraction& value) {
  const std::string above = std::to_string(static_cast<std::int64_t>(value.above));
  return value.below == 1 ? above
                          : above + "/" + std::to_string(static_cast<std::int64_t>(value.below));
}

Written drawn_rational() {
  const Fraction value = fraction(*rc::gen::inRange(-60, 61), *rc::gen::inRange(1, 13));
  return {value, text_of(value)};
}

Written drawn_number() {
  const int kind = *rc::gen::inRange(0, 4);
  if (kind < 2) return drawn_rational();
  const std::string text =
      std::to_string(*rc::gen::inRange(-40, 41)) + "." + std::to_string(*rc::gen::inRange(0, 1000));
  if (kind == 2) return {std::stof(text), text};
  return {std::stod(text), text + "d0"};
}

double widened(const Number& number) {
  return std::visit(
      [](const auto& value) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Fraction>)
          return static_cast<double>(value.above) / static_cast<double>(value.below);
        else
          return static_cast<double>(value);
      },
      number);
}

template <class Float>
Float floats(char sign, Float left, Float right) {
  return sign == '+'   ? left + right
         : sign == '-' ? left - right
         : sign == '*' ? left * right
                       : left / right;
}

Fraction fractions(char sign, const Fraction& l, const Fraction& r) {
  if (sign == '*') return fraction(l.above * r.above, l.below * r.below);
  if (sign == '/') return fraction(l.above * r.below, l.below * r.above);
  const WideInteger other = r.above * l.below;
  return fraction(l.above * r.below + (sign == '+' ? other : -other), l.below * r.below);
}

/// In the widest kind of the two: ratio, single, double.
Number result(char sign, const Number& left, const Number& right) {
  switch (std::max(left.index(), right.index())) {
    case 0:
      return fractions(sign, std::get<0>(left), std::get<0>(right));
    case 1:
      return floats(sign, static_cast<float>(widened(left)), static_cast<float>(widened(right)));
    default:
      return floats(sign, widened(left), widened(right));
  }
}

bool is_zero(const Number& number) { return widened(number) == 0; }

/// The text is the number, read back in its own precision.
bool says(const std::string& text, const Number& number) {
  if (const auto* value = std::get_if<Fraction>(&number)) return text == text_of(*value);
  if (text.find('.') == std::string::npos) return false;
  if (const auto* value = std::get_if<float>(&number))
    return std::strtof(text.c_str(), nullptr) == *value;
  return std::strtod(text.c_str(), nullptr) == std::get<double>(number);
}

int compared(const Number& left, const Number& right) {
  const auto exact = [](const Number& number) {
    const auto* value = std::get_if<Fraction>(&number);
    return value != nullptr ? *value : exactly(widened(number));
  };
  const Fraction l = exact(left), r = exact(right);
  const WideInteger one = l.above * r.below, other = r.above * l.below;
  return one < other ? -1 : one > other ? 1 : 0;
}

std::string truth(bool value) { return value ? "t" : "nil"; }

RC_GTEST_PROP(LispTower, TwoNumbersGiveOneOfTheWiderKind, ()) {
  const Written left = drawn_number(), right = drawn_number();
  test::LispFixture lisp;
  for (const char sign : {'+', '-', '*', '/'}) {
    if (sign == '/' && is_zero(right.number)) continue;
    const std::string form = std::string("(") + sign + " " + left.text + " " + right.text + ")";
    const std::string value = lisp.value(form);
    RC_LOG() << form << " = " << value << "\n";
    RC_ASSERT(says(value, result(sign, left.number, right.number)));
  }
}

RC_GTEST_PROP(LispTower, DivisionByAnyZeroIsAnError, ()) {
  const Written left = drawn_number();
  test::LispFixture lisp;

  for (const char* zero : {"0", "0.0", "0d0", "-0.0"})
    RC_ASSERT(lisp.value("(/ " + left.text + " " + zero + ")").starts_with("error: "));
}

RC_GTEST_PROP(LispTower, ComparisonsAreExactWhateverTheKinds, ()) {
  const Written left = drawn_number();
  // A close neighbour of another kind every second time.
  Written right = drawn_number();
  if (*rc::gen::arbitrary<bool>()) {
    right.text = left.text.ends_with("d0") ? left.text.substr(0, left.text.size() - 2) : left.text;
    if (left.number.index() == 2) right.number = std::stof(right.text);
    if (left.number.index() == 1) right = {std::stod(right.text), right.text + "d0"};
    if (left.number.index() == 0) right.number = left.number;
  }
  const int order = compared(left.number, right.number);
  const std::string both = " " + left.text + " " + right.text + ")";
  test::LispFixture lisp;
  RC_LOG() << both << " " << order << "\n";

  RC_ASSERT(lisp.value("(<" + both) == truth(order < 0));
  RC_ASSERT(lisp.value("(<=" + both) == truth(order <= 0));
  RC_ASSERT(lisp.value("(=" + both) == truth(order == 0));
  RC_ASSERT(lisp.value("(/=" + both) == truth(order != 0));
  RC_ASSERT(lisp.value("(>=" + both) == truth(order >= 0));
  RC_ASSERT(lisp.value("(>" + both) == truth(order > 0));
  RC_ASSERT(lisp.value("(max" + both) == lisp.value(order >= 0 ? left.text : right.text));
  RC_ASSERT(lisp.value("(min" + both) == lisp.value(order <= 0 ? left.text : right.text));
}

RC_GTEST_PROP(LispTower, RationalsAreRoundedToTheNeighbourThatIsAskedFor, ()) {
  const Written number = drawn_rational(), divisor = drawn_rational();
  RC_PRE(!is_zero(divisor.number));
  const Fraction quotient = fractions('/', std::get<0>(number.number), std::get<0>(divisor.number));
  const WideInteger toward_zero = quotient.above / quotient.below;
  const WideInteger below = toward_zero - (quotient.above < toward_zero * quotient.below ? 1 : 0);
  const WideInteger above = toward_zero + (quotient.above > toward_zero * quotient.below ? 1 : 0);
  const WideInteger twice =
      2 * (quotient.above - below * quotient.below);  // over the lower, doubled
  const bool up = twice > quotient.below || (twice == quotient.below && below % 2 != 0);
  const WideInteger nearest = up ? above : below;
  const auto text = [](WideInteger value) {
    return std::to_string(static_cast<std::int64_t>(value));
  };
  const auto rest = [&](WideInteger whole) {
    return text_of(fractions('-', std::get<0>(number.number),
                             fractions('*', {whole, 1}, std::get<0>(divisor.number))));
  };
  const std::string both = " " + number.text + " " + divisor.text + ")";
  test::LispFixture lisp;
  RC_LOG() << both << "\n";

  RC_ASSERT(lisp.value("(floor" + both) == text(below));
  RC_ASSERT(lisp.value("(ceiling" + both) == text(above));
  RC_ASSERT(lisp.value("(truncate" + both) == text(toward_zero));
  RC_ASSERT(lisp.value("(round" + both) == text(nearest));
  RC_ASSERT(lisp.value("(mod" + both) == rest(below));
  RC_ASSERT(lisp.value("(rem" + both) == rest(toward_zero));
}

RC_GTEST_PROP(LispTower, ManyArgumentsAreTakenFromTheLeft, ()) {
  const std::vector<Written> numbers{drawn_number(), drawn_number(), drawn_number(),
                                     drawn_number()};
  test::LispFixture lisp;
  for (const char sign : {'+', '-', '*'}) {
    std::string form = std::string("(") + sign;
    Number expected = numbers[0].number;
    for (std::size_t at = 0; at < numbers.size(); ++at) {
      form += " " + numbers[at].text;
      if (at > 0) expected = result(sign, expected, numbers[at].number);
    }
    const std::string value = lisp.value(form + ")");
    RC_LOG() << form << ") = " << value << "\n";
    RC_ASSERT(says(value, expected));
  }
}

RC_GTEST_PROP(LispTower, SignsAndStepsKeepTheKind, ()) {
  const Written number = drawn_number();
  const Number one = Fraction{1, 1}, zero = Fraction{0, 1};
  test::LispFixture lisp;

  RC_ASSERT(says(lisp.value("(1+ " + number.text + ")"), result('+', number.number, one)));
  RC_ASSERT(says(lisp.value("(1- " + number.text + ")"), result('-', number.number, one)));
  RC_ASSERT(says(lisp.value("(- " + number.text + ")"), result('-', zero, number.number)));
  const int sign = compared(number.number, zero);
  RC_ASSERT(says(lisp.value("(abs " + number.text + ")"),
                 sign < 0 ? result('-', zero, number.number) : number.number));
  RC_ASSERT(lisp.value("(plusp " + number.text + ")") == truth(sign > 0));
  RC_ASSERT(lisp.value("(minusp " + number.text + ")") == truth(sign < 0));
  RC_ASSERT(lisp.value("(zerop " + number.text + ")") == truth(sign == 0));
  RC_ASSERT(lisp.value("(rationalp " + number.text + ")") == truth(number.number.index() == 0));
}

}  // namespace
}  // namespace skein::htn::tower
