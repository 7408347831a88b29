// SPDX-License-Identifier: Apache-2.0
#include "skein/htn/number.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "terms/wide_integer.hpp"

namespace skein::htn {

namespace {

constexpr double kTwoTo63 = 9223372036854775808.0;

bool exact(const Number& number) {
  return number.kind == NumberKind::kInteger || number.kind == NumberKind::kRatio;
}

struct Floor {
  std::int64_t quotient;
  std::int64_t rest;  // of the sign of the denominator, that is not negative
};

Floor floor_of(const Number& number) {
  Floor floor{number.numerator / number.denominator, number.numerator % number.denominator};
  if (floor.rest < 0) {
    --floor.quotient;
    floor.rest += number.denominator;
  }
  return floor;
}

// Compares rest/denominator with a fraction, both in [0, 1), binary digit by digit; a double has
// less than 1100 of them, so this ends.
int compare_fractions(std::int64_t rest, std::int64_t denominator, double fraction) {
  WideInteger left = rest;
  while (left != 0 && fraction != 0) {
    left *= 2;
    fraction *= 2;
    const bool left_digit = left >= denominator;
    const bool right_digit = fraction >= 1;
    if (left_digit != right_digit) return left_digit ? 1 : -1;
    if (left_digit) left -= denominator;
    if (right_digit) fraction -= 1;
  }
  return left != 0 ? 1 : fraction != 0 ? -1 : 0;
}

template <class Value>
int compare_values(Value left, Value right) {
  return left < right ? -1 : left > right ? 1 : 0;
}

int compare_exact_with_float(const Number& left, double right) {
  if (right >= kTwoTo63) return -1;
  if (right < -kTwoTo63) return 1;
  const Floor floor = floor_of(left);
  const double whole = std::floor(right);
  const int order = compare_values(floor.quotient, static_cast<std::int64_t>(whole));
  return order != 0 ? order : compare_fractions(floor.rest, left.denominator, right - whole);
}

// Exact, whatever the kinds; -1, 0 or 1.
int compare(const Number& left, const Number& right) {
  if (exact(left) && exact(right)) {
    return compare_values(WideInteger{left.numerator} * right.denominator,
                          WideInteger{right.numerator} * left.denominator);
  }
  if (exact(left)) return compare_exact_with_float(left, right.real);
  if (exact(right)) return -compare_exact_with_float(right, left.real);
  return compare_values(left.real, right.real);
}

WideInteger greatest_common_divisor(WideInteger left, WideInteger right) {
  if (left < 0) left = -left;
  while (right != 0) left = std::exchange(right, left % right);
  return left;
}

constexpr const char* kIntegerOverflow = "the result is an integer beyond 64 bits";

Result<Number, Failure> exact_number(WideInteger numerator, WideInteger denominator) {
  if (denominator == 0) return failure("division by zero");
  if (denominator < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  const WideInteger divisor =
      denominator == 1 ? WideInteger{1} : greatest_common_divisor(numerator, denominator);
  numerator /= divisor;
  denominator /= divisor;
  if (!fits_64_bits(numerator) || !fits_64_bits(denominator)) return failure(kIntegerOverflow);
  const auto small_denominator = static_cast<std::int64_t>(denominator);
  const NumberKind kind = small_denominator == 1 ? NumberKind::kInteger : NumberKind::kRatio;
  return Number{kind, static_cast<std::int64_t>(numerator), small_denominator, 0};
}

float to_single(const Number& number) {
  if (number.kind == NumberKind::kInteger) return static_cast<float>(number.numerator);
  return static_cast<float>(to_double(number));
}

// The four operations, once for each type they are made in.
struct Plus {
  template <class Real>
  static Real of(Real left, Real right) {
    return left + right;
  }
  static Result<Number, Failure> of(const Number& left, const Number& right) {
    return exact_number(WideInteger{left.numerator} * right.denominator +
                            WideInteger{right.numerator} * left.denominator,
                        WideInteger{left.denominator} * right.denominator);
  }
};

struct Minus {
  template <class Real>
  static Real of(Real left, Real right) {
    return left - right;
  }
  static Result<Number, Failure> of(const Number& left, const Number& right) {
    return exact_number(WideInteger{left.numerator} * right.denominator -
                            WideInteger{right.numerator} * left.denominator,
                        WideInteger{left.denominator} * right.denominator);
  }
};

struct Times {
  template <class Real>
  static Real of(Real left, Real right) {
    return left * right;
  }
  static Result<Number, Failure> of(const Number& left, const Number& right) {
    return exact_number(WideInteger{left.numerator} * right.numerator,
                        WideInteger{left.denominator} * right.denominator);
  }
};

struct Over {
  template <class Real>
  static Real of(Real left, Real right) {
    return left / right;
  }
  static Result<Number, Failure> of(const Number& left, const Number& right) {
    return exact_number(WideInteger{left.numerator} * right.denominator,
                        WideInteger{left.denominator} * right.numerator);
  }
};

Result<Number, Failure> finite(Number number) {
  if (!std::isfinite(number.real)) return failure("the result is a float beyond its range");
  return number;
}

template <class Operation>
Result<Number, Failure> combine(const Number& left, const Number& right) {
  const NumberKind kind = std::max(left.kind, right.kind);
  if (kind == NumberKind::kDouble) {
    return finite(real(Operation::of(to_double(left), to_double(right))));
  }
  if (kind == NumberKind::kSingle) {
    return finite(single(static_cast<double>(Operation::of(to_single(left), to_single(right)))));
  }
  return Operation::of(left, right);
}

}  // namespace

Number single(double value) {
  return {NumberKind::kSingle, 0, 1, static_cast<double>(static_cast<float>(value))};
}

double to_double(const Number& number) {
  switch (number.kind) {
    case NumberKind::kInteger:
      return static_cast<double>(number.numerator);
    case NumberKind::kRatio:
      return static_cast<double>(static_cast<long double>(number.numerator) /
                                 static_cast<long double>(number.denominator));
    case NumberKind::kSingle:
    case NumberKind::kDouble:
      break;
  }
  return number.real;
}

bool equal_value(const Number& left, const Number& right) { return compare(left, right) == 0; }

bool less_value(const Number& left, const Number& right) { return compare(left, right) < 0; }

Result<Number, Failure> add(const Number& left, const Number& right) {
  return combine<Plus>(left, right);
}

Result<Number, Failure> subtract(const Number& left, const Number& right) {
  return combine<Minus>(left, right);
}

Result<Number, Failure> multiply(const Number& left, const Number& right) {
  return combine<Times>(left, right);
}

Result<Number, Failure> divide(const Number& left, const Number& right) {
  if (to_double(right) == 0) return failure("division by zero");
  return combine<Over>(left, right);
}

}  // namespace skein::htn
