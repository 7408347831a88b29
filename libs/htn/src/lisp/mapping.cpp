// SPDX-License-Identifier: Apache-2.0
// Functions that call a function on the items of lists.
#include <algorithm>
#include <array>

#include "lisp/builtins.hpp"
#include "lisp/options.hpp"

namespace skein::htn::lisp {

namespace {

using Lists = std::vector<std::vector<Term>>;

Result<Lists, Failure> lists_from(Machine& machine, Arguments arguments, std::size_t from) {
  Lists lists;
  for (std::size_t at = from; at < arguments.size(); ++at) {
    auto items = items_at(machine, arguments, at);
    if (!items) return tl::unexpected(items.error());
    lists.push_back(std::move(*items));
  }
  return lists;
}

// Calls the function on the first items, the second items, … until the shortest list ends or
// `visit` gives false.
template <class Visit>
Result<bool, Failure> for_each_row(Machine& machine, Arguments arguments, Visit visit) {
  const auto lists = lists_from(machine, arguments, 1);
  if (!lists) return tl::unexpected(lists.error());
  std::size_t rows = lists->front().size();
  for (const auto& list : *lists) rows = std::min(rows, list.size());
  std::vector<Term> row(lists->size());
  for (std::size_t at = 0; at < rows; ++at) {
    for (std::size_t list = 0; list < row.size(); ++list) row[list] = (*lists)[list][at];
    const Outcome value = machine.call(arguments[0], row);
    if (!value) return tl::unexpected(value.error());
    if (!visit(*value)) return false;
  }
  return true;
}

Outcome mapcar(Machine& machine, Arguments arguments) {
  std::vector<Term> values;
  const auto done = for_each_row(machine, arguments, [&](Term value) {
    values.push_back(value);
    return true;
  });
  if (!done) return tl::unexpected(done.error());
  return machine.store().list(values);
}

Outcome mapc(Machine& machine, Arguments arguments) {
  const auto done = for_each_row(machine, arguments, [](Term) { return true; });
  if (!done) return tl::unexpected(done.error());
  return arguments[1];
}

Outcome mapcan(Machine& machine, Arguments arguments) {
  std::vector<Term> values;
  const auto done = for_each_row(machine, arguments, [&](Term value) {
    if (machine.store().is_list(value)) {
      const std::vector<Term> items = machine.store().items(value);
      values.insert(values.end(), items.begin(), items.end());
    }
    return machine.charge(values.size());
  });
  if (!done) return tl::unexpected(done.error());
  if (!*done) return failure(Machine::kTooLong);
  return machine.store().list(values);
}

// The first true value, or nil.
Outcome some(Machine& machine, Arguments arguments) {
  Term found = kNil;
  const auto done = for_each_row(machine, arguments, [&](Term value) {
    found = value;
    return value == kNil;
  });
  if (!done) return tl::unexpected(done.error());
  return *done ? kNil : found;
}

// The last value when all are true.
Outcome every(Machine& machine, Arguments arguments) {
  Term last = kTrue;
  const auto done = for_each_row(machine, arguments, [&](Term value) {
    last = value;
    return value != kNil;
  });
  if (!done) return tl::unexpected(done.error());
  return last;
}

Outcome notany(Machine& machine, Arguments arguments) {
  const Outcome found = some(machine, arguments);
  return found ? Outcome(TermStore::boolean(*found == kNil)) : found;
}

Outcome notevery(Machine& machine, Arguments arguments) {
  const Outcome all = every(machine, arguments);
  return all ? Outcome(TermStore::boolean(*all == kNil)) : all;
}

Outcome funcall(Machine& machine, Arguments arguments) {
  return machine.call(arguments[0], arguments.subspan(1));
}

// The last argument is a list of further ones.
Outcome apply(Machine& machine, Arguments arguments) {
  const auto last = items_at(machine, arguments, arguments.size() - 1);
  if (!last) return tl::unexpected(last.error());
  std::vector<Term> all(arguments.begin() + 1, arguments.end() - 1);
  all.insert(all.end(), last->begin(), last->end());
  return machine.call(arguments[0], all);
}

Outcome reduce(Machine& machine, Arguments arguments) {
  const auto options = read_options(machine, arguments, 2, {":key", ":initial-value", ":from-end"});
  if (!options) return tl::unexpected(options.error());
  auto items = items_at(machine, arguments, 1);
  if (!items) return tl::unexpected(items.error());
  for (Term& item : *items) {
    const Outcome key = options->key_of(machine, item);
    if (!key) return key;
    item = *key;
  }
  if (options->from_end) std::reverse(items->begin(), items->end());
  if (options->initial) items->insert(items->begin(), *options->initial);
  if (items->empty()) return machine.call(arguments[0], {});
  Term value = items->front();
  for (std::size_t at = 1; at < items->size(); ++at) {
    std::array<Term, 2> pair{value, (*items)[at]};
    if (options->from_end) std::swap(pair[0], pair[1]);
    const Outcome next = machine.call(arguments[0], pair);
    if (!next) return next;
    value = *next;
  }
  return value;
}

struct Keyed {
  Term key;
  Term item;
};

// Merges two sorted runs; of equal items that of the left run comes first.
Result<std::vector<Keyed>, Failure> merged(Machine& machine, Term before,
                                           std::span<const Keyed> left,
                                           std::span<const Keyed> right) {
  std::vector<Keyed> out;
  out.reserve(left.size() + right.size());
  while (!left.empty() && !right.empty()) {
    const Outcome right_first =
        machine.call(before, std::array{right.front().key, left.front().key});
    if (!right_first) return tl::unexpected(right_first.error());
    std::span<const Keyed>& from = *right_first != kNil ? right : left;
    out.push_back(from.front());
    from = from.subspan(1);
  }
  out.insert(out.end(), left.begin(), left.end());
  out.insert(out.end(), right.begin(), right.end());
  return out;
}

// A merge sort of our own: the order is one that a program gives, which may contradict itself.
Outcome sort(Machine& machine, Arguments arguments) {
  const auto options = read_options(machine, arguments, 2, {":key"});
  if (!options) return tl::unexpected(options.error());
  const auto items = items_at(machine, arguments, 0);
  if (!items) return tl::unexpected(items.error());
  std::vector<Keyed> all;
  for (const Term item : *items) {
    const Outcome key = options->key_of(machine, item);
    if (!key) return key;
    all.push_back({*key, item});
  }
  for (std::size_t run = 1; run < all.size(); run *= 2) {
    for (std::size_t at = 0; at + run < all.size(); at += 2 * run) {
      const std::span<const Keyed> both =
          std::span<const Keyed>(all).subspan(at, std::min(2 * run, all.size() - at));
      const auto sorted = merged(machine, arguments[1], both.first(run), both.subspan(run));
      if (!sorted) return tl::unexpected(sorted.error());
      std::copy(sorted->begin(), sorted->end(), all.begin() + static_cast<std::ptrdiff_t>(at));
    }
  }
  std::vector<Term> out;
  for (const Keyed& keyed : all) out.push_back(keyed.item);
  return machine.store().list(out);
}

}  // namespace

std::span<const Builtin> mapping_builtins() {
  static constexpr std::array kTable{
      Builtin{"mapcar", 2, kAnyCount, &mapcar},
      Builtin{"mapc", 2, kAnyCount, &mapc},
      Builtin{"mapcan", 2, kAnyCount, &mapcan},
      Builtin{"some", 2, kAnyCount, &some},
      Builtin{"every", 2, kAnyCount, &every},
      Builtin{"notany", 2, kAnyCount, &notany},
      Builtin{"notevery", 2, kAnyCount, &notevery},
      Builtin{"funcall", 1, kAnyCount, &funcall},
      Builtin{"apply", 2, kAnyCount, &apply},
      Builtin{"reduce", 2, 8, &reduce},
      Builtin{"sort", 2, 4, &sort},
      Builtin{"stable-sort", 2, 4, &sort},
  };
  return kTable;
}

}  // namespace skein::htn::lisp
