// SPDX-License-Identifier: Apache-2.0
// Functions of numbers that keep the kinds of their arguments.
#include <array>
#include <cmath>

#include "lisp/builtins.hpp"

namespace skein::htn::lisp {

namespace {

constexpr std::string_view kANumber = "a number";

using Operation = Result<Number, Failure> (*)(const Number&, const Number&);

Outcome as_term(Machine& machine, const Result<Number, Failure>& result) {
  if (!result) return tl::unexpected(result.error());
  return machine.store().number(*result);
}

// From left to right, as the rounding of floats depends on it.
Outcome fold(Machine& machine, Arguments arguments, Number value, std::size_t from,
             Operation operation) {
  for (std::size_t at = from; at < arguments.size(); ++at) {
    const Number* next = number_at(machine, arguments, at);
    if (next == nullptr) return wrong_argument(machine, arguments, at, kANumber);
    const auto result = operation(value, *next);
    if (!result) return tl::unexpected(result.error());
    value = *result;
  }
  return machine.store().number(value);
}

template <Operation kOperation>
Outcome from_first(Machine& machine, Arguments arguments) {
  const Number* first = number_at(machine, arguments, 0);
  if (first == nullptr) return wrong_argument(machine, arguments, 0, kANumber);
  return fold(machine, arguments, *first, 1, kOperation);
}

Outcome plus(Machine& machine, Arguments arguments) {
  if (arguments.empty()) return machine.store().integer(0);
  return from_first<&htn::add>(machine, arguments);
}

Outcome times(Machine& machine, Arguments arguments) {
  if (arguments.empty()) return machine.store().integer(1);
  return from_first<&htn::multiply>(machine, arguments);
}

// For floats not 0 - x, which loses the sign of zero.
Result<Number, Failure> negated(const Number& number) {
  if (number.kind == NumberKind::kSingle) return single(-number.real);
  if (number.kind == NumberKind::kDouble) return real(-number.real);
  return htn::subtract(integer(0), number);
}

Outcome minus(Machine& machine, Arguments arguments) {
  if (arguments.size() > 1) return from_first<&htn::subtract>(machine, arguments);
  const Number* number = number_at(machine, arguments, 0);
  if (number == nullptr) return wrong_argument(machine, arguments, 0, kANumber);
  return as_term(machine, negated(*number));
}

Outcome over(Machine& machine, Arguments arguments) {
  if (arguments.size() > 1) return from_first<&htn::divide>(machine, arguments);
  return fold(machine, arguments, integer(1), 0, &htn::divide);
}

template <std::int64_t kStep>
Outcome stepped(Machine& machine, Arguments arguments) {
  return fold(machine, arguments, integer(kStep), 0, &htn::add);
}

Outcome absolute(Machine& machine, Arguments arguments) {
  const Number* number = number_at(machine, arguments, 0);
  if (number == nullptr) return wrong_argument(machine, arguments, 0, kANumber);
  const bool negative = number->real < 0 || std::signbit(number->real) || number->numerator < 0;
  return negative ? as_term(machine, negated(*number)) : Outcome(arguments[0]);
}

// One of the arguments, the first among equals: its kind does not change.
template <bool kLargest>
Outcome extreme(Machine& machine, Arguments arguments) {
  std::size_t best = 0;
  for (std::size_t at = 0; at < arguments.size(); ++at) {
    const Number* number = number_at(machine, arguments, at);
    if (number == nullptr) return wrong_argument(machine, arguments, at, kANumber);
    const Number& so_far = *number_at(machine, arguments, best);
    if (kLargest ? less_value(so_far, *number) : less_value(*number, so_far)) best = at;
  }
  return arguments[best];
}

Outcome to_float(Machine& machine, Arguments arguments) {
  for (std::size_t at = 0; at < arguments.size(); ++at) {
    if (number_at(machine, arguments, at) == nullptr) {
      return wrong_argument(machine, arguments, at, kANumber);
    }
  }
  const Number& number = *number_at(machine, arguments, 0);
  if (arguments.size() == 2) {
    const NumberKind kind = number_at(machine, arguments, 1)->kind;
    if (kind == NumberKind::kDouble) return machine.store().number(real(to_double(number)));
    const Number made = single(to_double(number));
    if (!std::isfinite(made.real)) return failure("a float beyond its range");
    return machine.store().number(made);
  }
  if (number.kind == NumberKind::kSingle || number.kind == NumberKind::kDouble) {
    return arguments[0];
  }
  return machine.store().number(single(to_double(number)));
}

Outcome square_root(Machine& machine, Arguments arguments) {
  const Number* number = number_at(machine, arguments, 0);
  if (number == nullptr || to_double(*number) < 0) {
    return wrong_argument(machine, arguments, 0, "a number that is not negative");
  }
  const double root = std::sqrt(to_double(*number));
  return machine.store().number(number->kind == NumberKind::kDouble ? real(root) : single(root));
}

Number one_of_kind(NumberKind kind) {
  if (kind == NumberKind::kSingle) return single(1);
  return kind == NumberKind::kDouble ? real(1) : integer(1);
}

// By squaring; the power is not negative.
Result<Number, Failure> integer_power(Number base, std::uint64_t power) {
  Number result = one_of_kind(base.kind);
  while (true) {
    if ((power & 1U) != 0) {
      const auto product = htn::multiply(result, base);
      if (!product) return product;
      result = *product;
    }
    power >>= 1U;
    if (power == 0) return result;
    const auto square = htn::multiply(base, base);
    if (!square) return square;
    base = *square;
  }
}

Outcome power(Machine& machine, Arguments arguments) {
  const Number* base = number_at(machine, arguments, 0);
  if (base == nullptr) return wrong_argument(machine, arguments, 0, kANumber);
  const Number* exponent = number_at(machine, arguments, 1);
  if (exponent == nullptr) return wrong_argument(machine, arguments, 1, kANumber);
  if (exponent->kind == NumberKind::kInteger) {
    const bool negative = exponent->numerator < 0;
    const auto magnitude = static_cast<std::uint64_t>(exponent->numerator);
    const auto result = integer_power(*base, negative ? 0 - magnitude : magnitude);
    if (!result || !negative) return as_term(machine, result);
    return as_term(machine, htn::divide(integer(1), *result));
  }
  const double result = std::pow(to_double(*base), to_double(*exponent));
  if (!std::isfinite(result)) return failure("the result is no real number, or beyond its range");
  const bool is_double = base->kind == NumberKind::kDouble || exponent->kind == NumberKind::kDouble;
  return machine.store().number(is_double ? real(result) : single(result));
}

}  // namespace

std::span<const Builtin> arithmetic_builtins() {
  static constexpr std::array kTable{
      Builtin{"+", 0, kAnyCount, &plus},
      Builtin{"-", 1, kAnyCount, &minus},
      Builtin{"*", 0, kAnyCount, &times},
      Builtin{"/", 1, kAnyCount, &over},
      Builtin{"1+", 1, 1, &stepped<1>},
      Builtin{"1-", 1, 1, &stepped<-1>},
      Builtin{"abs", 1, 1, &absolute},
      Builtin{"max", 1, kAnyCount, &extreme<true>},
      Builtin{"min", 1, kAnyCount, &extreme<false>},
      Builtin{"float", 1, 2, &to_float},
      Builtin{"sqrt", 1, 1, &square_root},
      Builtin{"expt", 2, 2, &power},
  };
  return kTable;
}

}  // namespace skein::htn::lisp
