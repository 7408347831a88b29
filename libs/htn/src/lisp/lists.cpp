// SPDX-License-Identifier: Apache-2.0
// Functions that take lists apart and put them together.
#include <algorithm>
#include <array>

#include "lisp/builtins.hpp"
#include "skein/htn/utf8.hpp"

namespace skein::htn::lisp {

namespace {

Outcome make_list(Machine& machine, Arguments arguments) { return machine.store().list(arguments); }

Outcome make_list_star(Machine& machine, Arguments arguments) {
  return machine.store().list(arguments.first(arguments.size() - 1), arguments.back());
}

Outcome cons(Machine& machine, Arguments arguments) {
  return machine.store().pair(arguments[0], arguments[1]);
}

// The path from the last letter to the first: c[ad]*r.
Outcome walk(Machine& machine, Arguments arguments, std::string_view path) {
  Term term = arguments[0];
  for (auto step = path.rbegin(); step != path.rend(); ++step) {
    if (term == kNil) return kNil;
    if (!term.is(TermKind::kPair)) return wrong_argument(machine, arguments, 0, "a list");
    term = *step == 'a' ? machine.store().car(term) : machine.store().cdr(term);
  }
  return term;
}

struct A {
  static constexpr std::string_view kPath = "a";
};
struct D {
  static constexpr std::string_view kPath = "d";
};
struct AA {
  static constexpr std::string_view kPath = "aa";
};
struct AD {
  static constexpr std::string_view kPath = "ad";
};
struct DA {
  static constexpr std::string_view kPath = "da";
};
struct DD {
  static constexpr std::string_view kPath = "dd";
};
struct ADD {
  static constexpr std::string_view kPath = "add";
};
struct DDD {
  static constexpr std::string_view kPath = "ddd";
};
struct ADDD {
  static constexpr std::string_view kPath = "addd";
};

template <class Path>
Outcome part(Machine& machine, Arguments arguments) {
  return walk(machine, arguments, Path::kPath);
}

// What is left of a list after `count` items.
Outcome tail(Machine& machine, Arguments arguments, std::size_t list, std::int64_t count) {
  Term term = arguments[list];
  for (; count > 0 && term.is(TermKind::kPair); --count) {
    if (!machine.charge(1)) return failure(Machine::kTooLong);
    term = machine.store().cdr(term);
  }
  if (count > 0 && term != kNil) return wrong_argument(machine, arguments, list, "a list");
  return term;
}

Outcome item(Machine& machine, Arguments arguments, std::size_t list, std::int64_t position) {
  const Outcome rest = tail(machine, arguments, list, position);
  if (!rest || *rest == kNil) return rest;
  if (!rest->is(TermKind::kPair)) return wrong_argument(machine, arguments, list, "a list");
  return machine.store().car(*rest);
}

template <std::int64_t kPosition>
Outcome ordinal(Machine& machine, Arguments arguments) {
  return item(machine, arguments, 0, kPosition);
}

Result<std::int64_t, Failure> count_at(Machine& machine, Arguments arguments, std::size_t at) {
  const auto count = integer_at(machine, arguments, at);
  if (count && *count < 0) return wrong_argument(machine, arguments, at, "no negative integer");
  return count;
}

Outcome nth(Machine& machine, Arguments arguments) {
  const auto position = count_at(machine, arguments, 0);
  if (!position) return tl::unexpected(position.error());
  return item(machine, arguments, 1, *position);
}

Outcome elt(Machine& machine, Arguments arguments) {
  const auto position = count_at(machine, arguments, 1);
  if (!position) return tl::unexpected(position.error());
  return item(machine, arguments, 0, *position);
}

Outcome nthcdr(Machine& machine, Arguments arguments) {
  const auto count = count_at(machine, arguments, 0);
  if (!count) return tl::unexpected(count.error());
  return tail(machine, arguments, 1, *count);
}

// The last `count` pairs, without copying; all but them.
struct Cut {
  std::vector<Term> items;
  std::size_t at = 0;
};

Result<Cut, Failure> cut(Machine& machine, Arguments arguments) {
  auto items = items_at(machine, arguments, 0);
  if (!items) return tl::unexpected(items.error());
  std::int64_t count = 1;
  if (arguments.size() > 1) {
    const auto given = count_at(machine, arguments, 1);
    if (!given) return tl::unexpected(given.error());
    count = *given;
  }
  const auto size = static_cast<std::int64_t>(items->size());
  return Cut{std::move(*items), static_cast<std::size_t>(size - std::min(count, size))};
}

Outcome last(Machine& machine, Arguments arguments) {
  const auto where = cut(machine, arguments);
  if (!where) return tl::unexpected(where.error());
  return machine.store().list(Arguments(where->items).subspan(where->at));
}

Outcome butlast(Machine& machine, Arguments arguments) {
  const auto where = cut(machine, arguments);
  if (!where) return tl::unexpected(where.error());
  return machine.store().list(Arguments(where->items).first(where->at));
}

// Lists but the last, which may be anything.
Outcome append(Machine& machine, Arguments arguments) {
  if (arguments.empty()) return kNil;
  Term list = arguments.back();
  for (std::size_t at = arguments.size() - 1; at-- > 0;) {
    const auto items = items_at(machine, arguments, at);
    if (!items) return tl::unexpected(items.error());
    list = machine.store().list(*items, list);
  }
  return list;
}

Outcome length(Machine& machine, Arguments arguments) {
  if (arguments[0].is(TermKind::kString)) {
    const std::size_t size = count_characters(machine.store().text(arguments[0]));
    return machine.store().integer(static_cast<std::int64_t>(size));
  }
  std::int64_t count = 0;
  Term rest = arguments[0];
  for (; rest.is(TermKind::kPair); rest = machine.store().cdr(rest)) {
    if (!machine.charge(1)) return failure(Machine::kTooLong);
    ++count;
  }
  if (rest != kNil) return wrong_argument(machine, arguments, 0, "a list");
  return machine.store().integer(count);
}

Outcome reverse(Machine& machine, Arguments arguments) {
  auto items = items_at(machine, arguments, 0);
  if (!items) return tl::unexpected(items.error());
  std::reverse(items->begin(), items->end());
  return machine.store().list(*items);
}

// Items of a property list by their keys.
Outcome getf(Machine& machine, Arguments arguments) {
  const auto items = items_at(machine, arguments, 0);
  if (!items) return tl::unexpected(items.error());
  for (std::size_t at = 0; at + 1 < items->size(); at += 2) {
    if ((*items)[at] == arguments[1]) return (*items)[at + 1];
  }
  return arguments.size() > 2 ? arguments[2] : kNil;
}

// Helper of the form of that name: the first item, or (with nil after it) a check of the end.
Outcome destructure(Machine& machine, Arguments arguments) {
  if (arguments.size() == 2) {
    if (arguments[0] == kNil) return kNil;
    return failure("the list is longer than the pattern");
  }
  if (!arguments[0].is(TermKind::kPair)) return failure("the list is shorter than the pattern");
  return machine.store().car(arguments[0]);
}

Outcome identity(Machine& /*machine*/, Arguments arguments) { return arguments[0]; }

Outcome first_value(Machine& /*machine*/, Arguments arguments) {
  return arguments.empty() ? kNil : arguments[0];
}

}  // namespace

std::span<const Builtin> list_builtins() {
  static constexpr std::array kTable{
      Builtin{"list", 0, kAnyCount, &make_list},
      Builtin{"list*", 1, kAnyCount, &make_list_star},
      Builtin{"cons", 2, 2, &cons},
      Builtin{"car", 1, 1, &part<A>},
      Builtin{"cdr", 1, 1, &part<D>},
      Builtin{"rest", 1, 1, &part<D>},
      Builtin{"caar", 1, 1, &part<AA>},
      Builtin{"cadr", 1, 1, &part<AD>},
      Builtin{"cdar", 1, 1, &part<DA>},
      Builtin{"cddr", 1, 1, &part<DD>},
      Builtin{"caddr", 1, 1, &part<ADD>},
      Builtin{"cdddr", 1, 1, &part<DDD>},
      Builtin{"cadddr", 1, 1, &part<ADDD>},
      Builtin{"first", 1, 1, &ordinal<0>},
      Builtin{"second", 1, 1, &ordinal<1>},
      Builtin{"third", 1, 1, &ordinal<2>},
      Builtin{"fourth", 1, 1, &ordinal<3>},
      Builtin{"fifth", 1, 1, &ordinal<4>},
      Builtin{"sixth", 1, 1, &ordinal<5>},
      Builtin{"seventh", 1, 1, &ordinal<6>},
      Builtin{"eighth", 1, 1, &ordinal<7>},
      Builtin{"ninth", 1, 1, &ordinal<8>},
      Builtin{"tenth", 1, 1, &ordinal<9>},
      Builtin{"nth", 2, 2, &nth},
      Builtin{"elt", 2, 2, &elt},
      Builtin{"nthcdr", 2, 2, &nthcdr},
      Builtin{"last", 1, 2, &last},
      Builtin{"butlast", 1, 2, &butlast},
      Builtin{"append", 0, kAnyCount, &append},
      Builtin{"length", 1, 1, &length},
      Builtin{"list-length", 1, 1, &length},
      Builtin{"reverse", 1, 1, &reverse},
      Builtin{"nreverse", 1, 1, &reverse},
      Builtin{"copy-list", 1, 1, &identity},
      Builtin{"copy-tree", 1, 1, &identity},
      Builtin{"getf", 2, 3, &getf},
      Builtin{"destructuring-bind", 1, 2, &destructure},
      Builtin{"identity", 1, 1, &identity},
      Builtin{"values", 0, kAnyCount, &first_value},
  };
  return kTable;
}

}  // namespace skein::htn::lisp
