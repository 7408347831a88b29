// SPDX-License-Identifier: Apache-2.0
#include "lisp/builtins.hpp"

namespace skein::htn::lisp {

namespace {

constexpr std::size_t kLongestShown = 60;

std::string shown(const TermStore& store, Term term) {
  switch (term.kind()) {
    case TermKind::kSlot:
    case TermKind::kVariable:
    case TermKind::kLocal:
      return "an unbound variable";
    case TermKind::kSymbol:
      return term == kNil ? "nil" : "the symbol " + std::string(store.name(term));
    default:
      break;
  }
  std::string text = store.to_text(term);
  if (text.size() > kLongestShown) text = text.substr(0, kLongestShown) + "…";
  return text;
}

}  // namespace

tl::unexpected<Failure> wrong_argument(Machine& machine, Arguments arguments, std::size_t at,
                                       std::string_view expected) {
  return failure("argument " + std::to_string(at + 1) + " is " +
                 shown(machine.store(), arguments[at]) + ", expected " + std::string(expected));
}

const Number* number_at(Machine& machine, Arguments arguments, std::size_t at) {
  const Term term = arguments[at];
  return term.is(TermKind::kNumber) ? &machine.store().value(term) : nullptr;
}

Result<std::int64_t, Failure> integer_at(Machine& machine, Arguments arguments, std::size_t at) {
  const Number* number = number_at(machine, arguments, at);
  if (number == nullptr || number->kind != NumberKind::kInteger) {
    return wrong_argument(machine, arguments, at, "an integer");
  }
  return number->numerator;
}

Result<std::vector<Term>, Failure> items_at(Machine& machine, Arguments arguments, std::size_t at) {
  std::vector<Term> items;
  Term rest = arguments[at];
  for (; rest.is(TermKind::kPair); rest = machine.store().cdr(rest)) {
    if (!machine.charge(1)) return failure(Machine::kTooLong);
    items.push_back(machine.store().car(rest));
  }
  if (rest != kNil) return wrong_argument(machine, arguments, at, "a list");
  return items;
}

std::array<std::span<const Builtin>, 8> all_builtins() {
  return {arithmetic_builtins(), comparison_builtins(), division_builtins(), list_builtins(),
          sequence_builtins(),   mapping_builtins(),    text_builtins(),     table_builtins()};
}

const Builtin* builtin_of(std::string_view name) {
  for (const std::span<const Builtin> table : all_builtins()) {
    for (const Builtin& builtin : table) {
      if (builtin.name == name) return &builtin;
    }
  }
  return nullptr;
}

}  // namespace skein::htn::lisp
