// SPDX-License-Identifier: Apache-2.0
// Functions of strings and symbols, and those that print in Lisp: here they only give their value.
#include <array>

#include "lisp/builtins.hpp"

namespace skein::htn::lisp {

namespace {

constexpr std::size_t kLongestText = 65'536;

// The text a string designator stands for: a string, or the name of a symbol.
Result<std::string_view, Failure> text_at(Machine& machine, Arguments arguments, std::size_t at) {
  if (arguments[at].is(TermKind::kString)) {
    return std::string_view(machine.store().text(arguments[at]));
  }
  if (arguments[at].is(TermKind::kSymbol)) return machine.store().name(arguments[at]);
  return wrong_argument(machine, arguments, at, "a string or a symbol");
}

// As people read it: strings without quotes.
std::string plain_text(Machine& machine, Term term) {
  return term.is(TermKind::kString) ? machine.store().text(term) : machine.store().to_text(term);
}

// Names of symbols have no case of their own: with one of them case does not count.
template <bool kWithCase>
Outcome same_text(Machine& machine, Arguments arguments) {
  const auto left = text_at(machine, arguments, 0);
  if (!left) return tl::unexpected(left.error());
  const auto right = text_at(machine, arguments, 1);
  if (!right) return tl::unexpected(right.error());
  const bool symbols = arguments[0].is(TermKind::kSymbol) || arguments[1].is(TermKind::kSymbol);
  if (kWithCase && !symbols) return TermStore::boolean(*left == *right);
  return TermStore::boolean(machine.store().symbol(std::string(*left)) ==
                            machine.store().symbol(std::string(*right)));
}

Outcome symbol_name(Machine& machine, Arguments arguments) {
  if (!arguments[0].is(TermKind::kSymbol)) {
    return wrong_argument(machine, arguments, 0, "a symbol");
  }
  return machine.store().string(std::string(machine.store().name(arguments[0])));
}

Outcome intern(Machine& machine, Arguments arguments) {
  const auto text = text_at(machine, arguments, 0);
  if (!text) return tl::unexpected(text.error());
  return machine.store().symbol(std::string(*text));
}

Outcome string(Machine& machine, Arguments arguments) {
  const auto text = text_at(machine, arguments, 0);
  if (!text) return tl::unexpected(text.error());
  return machine.store().string(std::string(*text));
}

Outcome written(Machine& machine, Arguments arguments) {
  return machine.store().string(machine.store().to_text(arguments[0]));
}

Outcome concatenated(Machine& machine, Arguments arguments) {
  if (arguments[0] != machine.store().symbol("string")) {
    return wrong_argument(machine, arguments, 0, "the type string");
  }
  std::string text;
  for (std::size_t at = 1; at < arguments.size(); ++at) {
    if (!arguments[at].is(TermKind::kString)) {
      return wrong_argument(machine, arguments, at, "a string");
    }
    text += machine.store().text(arguments[at]);
    if (text.size() > kLongestText) return failure("the text becomes too long");
  }
  return machine.store().string(text);
}

// ~a and ~d as people read it, ~s as it is written, ~% and ~& new lines, ~~ a tilde; other
// directives are kept as they are.
Result<std::string, Failure> formatted(Machine& machine, Arguments arguments, std::size_t control) {
  if (!arguments[control].is(TermKind::kString)) {
    return wrong_argument(machine, arguments, control, "a string");
  }
  const std::string pattern = machine.store().text(arguments[control]);
  std::string text;
  std::size_t next = control + 1;
  for (std::size_t at = 0; at < pattern.size() && text.size() <= kLongestText; ++at) {
    if (pattern[at] != '~' || at + 1 == pattern.size()) {
      text += pattern[at];
      continue;
    }
    const char directive = static_cast<char>(pattern[++at] | 0x20);
    const bool takes = directive == 'a' || directive == 's' || directive == 'd';
    if (takes && next == arguments.size()) return failure("too few arguments for the text");
    if (directive == 's') {
      text += machine.store().to_text(arguments[next++]);
    } else if (takes) {
      text += plain_text(machine, arguments[next++]);
    } else if (pattern[at] == '%' || pattern[at] == '&') {
      text += '\n';
    } else if (pattern[at] == '~') {
      text += '~';
    } else {
      text.append("~").append(1, pattern[at]);
    }
  }
  if (text.size() > kLongestText) return failure("the text becomes too long");
  if (!machine.charge(text.size())) return failure(Machine::kTooLong);
  return text;
}

// (format nil …) gives the text; to any other destination nothing is written, and nil given.
Outcome format(Machine& machine, Arguments arguments) {
  if (arguments[0] != kNil) return kNil;
  const auto text = formatted(machine, arguments, 1);
  if (!text) return tl::unexpected(text.error());
  return machine.store().string(*text);
}

// The message is a format, or any term.
Outcome error(Machine& machine, Arguments arguments) {
  if (!arguments[0].is(TermKind::kString)) return failure(plain_text(machine, arguments[0]));
  auto text = formatted(machine, arguments, 0);
  return tl::unexpected(text ? Failure{std::move(*text)} : text.error());
}

Outcome prints_argument(Machine& /*machine*/, Arguments arguments) { return arguments[0]; }

Outcome prints_nothing(Machine& /*machine*/, Arguments /*arguments*/) { return kNil; }

Outcome reports(Machine& /*machine*/, Arguments /*arguments*/) { return kTrue; }

}  // namespace

std::span<const Builtin> text_builtins() {
  static constexpr std::array kTable{
      Builtin{"string=", 2, 2, &same_text<true>},
      Builtin{"string-equal", 2, 2, &same_text<false>},
      Builtin{"symbol-name", 1, 1, &symbol_name},
      Builtin{"intern", 1, 1, &intern},
      Builtin{"string", 1, 1, &string},
      Builtin{"princ-to-string", 1, 1, &written},
      Builtin{"concatenate", 1, kAnyCount, &concatenated},
      Builtin{"format", 2, kAnyCount, &format},
      Builtin{"error", 1, kAnyCount, &error, true},
      Builtin{"print", 1, 2, &prints_argument},
      Builtin{"princ", 1, 2, &prints_argument},
      Builtin{"prin1", 1, 2, &prints_argument},
      Builtin{"pprint", 1, 2, &prints_nothing},
      Builtin{"terpri", 0, 1, &prints_nothing},
      // SHOP's helpers for debugging, which domains name.
      Builtin{"print-current-state", 0, kAnyCount, &reports},
      Builtin{"print-current-tasks", 0, kAnyCount, &reports},
      Builtin{"print-current-plan", 0, kAnyCount, &reports},
      Builtin{"print-last-action", 0, kAnyCount, &reports},
      Builtin{"query-current-state", 0, kAnyCount, &prints_nothing},
  };
  return kTable;
}

}  // namespace skein::htn::lisp
