// SPDX-License-Identifier: Apache-2.0
// Comparisons, equalities and predicates.
#include <array>

#include "lisp/builtins.hpp"

namespace skein::htn::lisp {

namespace {

bool unbound(Term term) {
  return term.is(TermKind::kVariable) || term.is(TermKind::kSlot) || term.is(TermKind::kLocal);
}

// Numbers by value. Other terms, which Lisp would refuse, are compared as terms: translated
// domains write (call = ?a ?b) for objects.
Result<bool, Failure> same_number(Machine& machine, Arguments arguments, std::size_t left,
                                  std::size_t right) {
  for (const std::size_t at : {left, right}) {
    if (unbound(arguments[at])) return wrong_argument(machine, arguments, at, "a value");
  }
  const Number* first = number_at(machine, arguments, left);
  const Number* second = number_at(machine, arguments, right);
  if (first == nullptr || second == nullptr) return arguments[left] == arguments[right];
  return equal_value(*first, *second);
}

Outcome equal_numbers(Machine& machine, Arguments arguments) {
  for (std::size_t at = 0; at + 1 < arguments.size(); ++at) {
    const auto same = same_number(machine, arguments, at, at + 1);
    if (!same) return tl::unexpected(same.error());
    if (!*same) return kNil;
  }
  return kTrue;
}

Outcome different_numbers(Machine& machine, Arguments arguments) {
  if (!machine.charge(arguments.size() * arguments.size())) return failure(Machine::kTooLong);
  for (std::size_t left = 0; left < arguments.size(); ++left) {
    for (std::size_t right = left + 1; right < arguments.size(); ++right) {
      const auto same = same_number(machine, arguments, left, right);
      if (!same) return tl::unexpected(same.error());
      if (*same) return kNil;
    }
  }
  return kTrue;
}

struct Less {
  static bool of(const Number& left, const Number& right) { return less_value(left, right); }
};
struct LessOrEqual {
  static bool of(const Number& left, const Number& right) { return !less_value(right, left); }
};
struct Greater {
  static bool of(const Number& left, const Number& right) { return less_value(right, left); }
};
struct GreaterOrEqual {
  static bool of(const Number& left, const Number& right) { return !less_value(left, right); }
};

template <class Order>
Outcome ordered(Machine& machine, Arguments arguments) {
  const Number* previous = nullptr;
  bool holds = true;
  for (std::size_t at = 0; at < arguments.size(); ++at) {
    const Number* number = number_at(machine, arguments, at);
    if (number == nullptr) return wrong_argument(machine, arguments, at, "a number");
    holds = holds && (previous == nullptr || Order::of(*previous, *number));
    previous = number;
  }
  return TermStore::boolean(holds);
}

// Terms are kept once: eq, eql and equal all compare what is written.
Outcome equal_terms(Machine& /*machine*/, Arguments arguments) {
  return TermStore::boolean(arguments[0] == arguments[1]);
}

Outcome loosely_equal(Machine& machine, Arguments arguments) {
  return TermStore::boolean(machine.store().loose(arguments[0]) ==
                            machine.store().loose(arguments[1]));
}

Outcome is_nil(Machine& /*machine*/, Arguments arguments) {
  return TermStore::boolean(arguments[0] == kNil);
}

template <TermKind kKind>
Outcome is_kind(Machine& /*machine*/, Arguments arguments) {
  return TermStore::boolean(arguments[0].is(kKind));
}

Outcome is_symbol(Machine& /*machine*/, Arguments arguments) {
  return TermStore::boolean(arguments[0].is(TermKind::kSymbol));
}

Outcome is_list(Machine& /*machine*/, Arguments arguments) {
  return TermStore::boolean(arguments[0].is(TermKind::kPair) || arguments[0] == kNil);
}

Outcome is_atom(Machine& /*machine*/, Arguments arguments) {
  return TermStore::boolean(!arguments[0].is(TermKind::kPair));
}

Outcome is_variable(Machine& machine, Arguments arguments) {
  const Term term = arguments[0];
  const bool named = term.is(TermKind::kSymbol) && machine.store().name(term).starts_with('?');
  return TermStore::boolean(named || unbound(term));
}

Outcome is_function(Machine& machine, Arguments arguments) {
  return TermStore::boolean(machine.is_function(arguments[0]));
}

template <NumberKind kFirst, NumberKind kLast>
Outcome is_number_kind(Machine& machine, Arguments arguments) {
  const Number* number = number_at(machine, arguments, 0);
  return TermStore::boolean(number != nullptr && number->kind >= kFirst && number->kind <= kLast);
}

template <class Order>
Outcome against_zero(Machine& machine, Arguments arguments) {
  const Number* number = number_at(machine, arguments, 0);
  if (number == nullptr) return wrong_argument(machine, arguments, 0, "a number");
  return TermStore::boolean(Order::of(*number, integer(0)));
}

struct Equal {
  static bool of(const Number& left, const Number& right) { return equal_value(left, right); }
};

template <std::int64_t kRest>
Outcome has_parity(Machine& machine, Arguments arguments) {
  const auto number = integer_at(machine, arguments, 0);
  if (!number) return tl::unexpected(number.error());
  return TermStore::boolean((*number & 1) == kRest);
}

}  // namespace

std::span<const Builtin> comparison_builtins() {
  static constexpr auto kInteger = NumberKind::kInteger;
  static constexpr auto kRatio = NumberKind::kRatio;
  static constexpr auto kSingle = NumberKind::kSingle;
  static constexpr auto kDouble = NumberKind::kDouble;
  static constexpr std::array kTable{
      Builtin{"=", 1, kAnyCount, &equal_numbers},
      Builtin{"/=", 1, kAnyCount, &different_numbers},
      Builtin{"<", 1, kAnyCount, &ordered<Less>},
      Builtin{"<=", 1, kAnyCount, &ordered<LessOrEqual>},
      Builtin{">", 1, kAnyCount, &ordered<Greater>},
      Builtin{">=", 1, kAnyCount, &ordered<GreaterOrEqual>},
      Builtin{"eq", 2, 2, &equal_terms},
      Builtin{"eql", 2, 2, &equal_terms},
      Builtin{"equal", 2, 2, &equal_terms},
      Builtin{"equalp", 2, 2, &loosely_equal},
      Builtin{"not", 1, 1, &is_nil},
      Builtin{"null", 1, 1, &is_nil},
      Builtin{"endp", 1, 1, &is_nil},
      Builtin{"consp", 1, 1, &is_kind<TermKind::kPair>},
      Builtin{"numberp", 1, 1, &is_kind<TermKind::kNumber>},
      Builtin{"stringp", 1, 1, &is_kind<TermKind::kString>},
      Builtin{"symbolp", 1, 1, &is_symbol},
      Builtin{"listp", 1, 1, &is_list},
      Builtin{"atom", 1, 1, &is_atom},
      Builtin{"variablep", 1, 1, &is_variable},
      Builtin{"functionp", 1, 1, &is_function},
      Builtin{"integerp", 1, 1, &is_number_kind<kInteger, kInteger>},
      Builtin{"rationalp", 1, 1, &is_number_kind<kInteger, kRatio>},
      Builtin{"realp", 1, 1, &is_number_kind<kInteger, kDouble>},
      Builtin{"floatp", 1, 1, &is_number_kind<kSingle, kDouble>},
      Builtin{"zerop", 1, 1, &against_zero<Equal>},
      Builtin{"plusp", 1, 1, &against_zero<Greater>},
      Builtin{"minusp", 1, 1, &against_zero<Less>},
      Builtin{"evenp", 1, 1, &has_parity<0>},
      Builtin{"oddp", 1, 1, &has_parity<1>},
  };
  return kTable;
}

}  // namespace skein::htn::lisp
