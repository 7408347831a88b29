// SPDX-License-Identifier: Apache-2.0
// Functions that round: floor, ceiling, truncate, round, mod, rem. Only the first of Lisp's two
// values is given.
#include <algorithm>
#include <array>
#include <cmath>

#include "lisp/builtins.hpp"
#include "terms/wide_integer.hpp"

namespace skein::htn::lisp {

namespace {

constexpr double kTwoTo63 = 9223372036854775808.0;

enum class Rounding : std::uint8_t { kFloor, kCeiling, kTruncate, kNearest };

double rounded(double value, Rounding rounding) {
  switch (rounding) {
    case Rounding::kFloor:
      return std::floor(value);
    case Rounding::kCeiling:
      return std::ceil(value);
    case Rounding::kTruncate:
      return std::trunc(value);
    case Rounding::kNearest:
      break;
  }
  const double below = std::floor(value);
  const double fraction = value - below;
  const bool up = fraction > 0.5 || (fraction == 0.5 && std::fmod(below, 2.0) != 0);
  return up ? below + 1 : below;
}

// Denominators are positive.
WideInteger rounded(WideInteger numerator, WideInteger denominator, Rounding rounding) {
  WideInteger below = numerator / denominator;
  WideInteger rest = numerator % denominator;
  if (rest < 0) {
    --below;
    rest += denominator;
  }
  if (rest == 0) return below;
  const WideInteger left = denominator - rest;
  const bool nearer_above = rest > left || (rest == left && (below & 1) != 0);
  const bool up = rounding == Rounding::kCeiling ||
                  (rounding == Rounding::kTruncate && numerator < 0) ||
                  (rounding == Rounding::kNearest && nearer_above);
  return up ? below + 1 : below;
}

constexpr const char* kBeyond = "the result is an integer beyond 64 bits";

bool exact(const Number& number) {
  return number.kind == NumberKind::kInteger || number.kind == NumberKind::kRatio;
}

// Of integers and ratios; the quotient itself may be a ratio beyond 64 bits.
Result<Number, Failure> exact_quotient(const Number& number, const Number& divisor,
                                       Rounding rounding) {
  if (divisor.numerator == 0) return failure("division by zero");
  const WideInteger sign = divisor.numerator < 0 ? -1 : 1;
  const WideInteger whole = rounded(sign * number.numerator * divisor.denominator,
                                    sign * divisor.numerator * number.denominator, rounding);
  if (!fits_64_bits(whole)) return failure(kBeyond);
  return integer(static_cast<std::int64_t>(whole));
}

Result<Number, Failure> float_to_integer(double number, Rounding rounding) {
  const double whole = rounded(number, rounding);
  if (!(whole >= -kTwoTo63 && whole < kTwoTo63)) return failure(kBeyond);
  return integer(static_cast<std::int64_t>(whole));
}

Result<Number, Failure> quotient(Machine& machine, Arguments arguments, Rounding rounding) {
  for (std::size_t at = 0; at < arguments.size(); ++at) {
    if (number_at(machine, arguments, at) == nullptr) {
      return wrong_argument(machine, arguments, at, "a number");
    }
  }
  const Number& number = *number_at(machine, arguments, 0);
  const Number divisor = arguments.size() == 1 ? integer(1) : *number_at(machine, arguments, 1);
  if (exact(number) && exact(divisor)) return exact_quotient(number, divisor, rounding);
  const auto divided = htn::divide(number, divisor);
  return divided ? float_to_integer(divided->real, rounding) : divided;
}

template <Rounding kRounding>
Outcome divide(Machine& machine, Arguments arguments) {
  const auto result = quotient(machine, arguments, kRounding);
  if (!result) return tl::unexpected(result.error());
  return machine.store().number(*result);
}

// Floats: fmod is exact, where number - quotient * divisor is not.
double float_rest(double number, double divisor, Rounding rounding) {
  const double rest = std::fmod(number, divisor);
  const bool fix = rounding == Rounding::kFloor && rest != 0 && (rest < 0) != (divisor < 0);
  return fix ? rest + divisor : rest;
}

// No quotient times divisor, which may lie beyond 64 bits where the rest does not.
std::int64_t integer_rest(std::int64_t number, std::int64_t divisor, Rounding rounding) {
  if (divisor == -1) return 0;
  const std::int64_t rest = number % divisor;
  const bool fix = rounding == Rounding::kFloor && rest != 0 && (rest < 0) != (divisor < 0);
  return fix ? rest + divisor : rest;
}

// What is left of the number: of the sign of the divisor (mod) or of the number (rem).
template <Rounding kRounding>
Outcome rest(Machine& machine, Arguments arguments) {
  for (std::size_t at = 0; at < arguments.size(); ++at) {
    if (number_at(machine, arguments, at) == nullptr) {
      return wrong_argument(machine, arguments, at, "a number");
    }
  }
  const Number number = *number_at(machine, arguments, 0);
  const Number divisor = *number_at(machine, arguments, 1);
  if (to_double(divisor) == 0) return failure("division by zero");
  const NumberKind kind = std::max(number.kind, divisor.kind);
  if (kind == NumberKind::kSingle || kind == NumberKind::kDouble) {
    const double left = float_rest(to_double(number), to_double(divisor), kRounding);
    return machine.store().number(kind == NumberKind::kDouble ? real(left) : single(left));
  }
  if (kind == NumberKind::kInteger) {
    return machine.store().integer(integer_rest(number.numerator, divisor.numerator, kRounding));
  }
  const auto whole = quotient(machine, arguments, kRounding);
  if (!whole) return tl::unexpected(whole.error());
  const auto taken = htn::multiply(*whole, divisor);
  if (!taken) return tl::unexpected(taken.error());
  const auto left = htn::subtract(number, *taken);
  if (!left) return tl::unexpected(left.error());
  return machine.store().number(*left);
}

}  // namespace

std::span<const Builtin> division_builtins() {
  static constexpr std::array kTable{
      Builtin{"floor", 1, 2, &divide<Rounding::kFloor>},
      Builtin{"ceiling", 1, 2, &divide<Rounding::kCeiling>},
      Builtin{"truncate", 1, 2, &divide<Rounding::kTruncate>},
      Builtin{"round", 1, 2, &divide<Rounding::kNearest>},
      Builtin{"mod", 2, 2, &rest<Rounding::kFloor>},
      Builtin{"rem", 2, 2, &rest<Rounding::kTruncate>},
  };
  return kTable;
}

}  // namespace skein::htn::lisp
