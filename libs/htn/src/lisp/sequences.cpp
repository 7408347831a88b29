// SPDX-License-Identifier: Apache-2.0
// Searching and filtering lists, lists as sets.
#include <algorithm>
#include <array>

#include "lisp/builtins.hpp"
#include "lisp/options.hpp"

namespace skein::htn::lisp {

namespace {

// What an item is looked for by: equality with a term, or a predicate; both on its key.
class Wanted {
 public:
  enum class Kind : std::uint8_t { kItem, kIf, kIfNot };

  Wanted(Kind kind, Term term, Options options)
      : kind_(kind), term_(term), options_(std::move(options)) {}

  Result<bool, Failure> is(Machine& machine, Term item) const {
    const Outcome key = options_.key_of(machine, item);
    if (!key) return tl::unexpected(key.error());
    if (kind_ == Kind::kItem) return options_.matches(machine, term_, *key);
    const Outcome outcome = machine.call(term_, std::array{*key});
    if (!outcome) return tl::unexpected(outcome.error());
    return (*outcome != kNil) == (kind_ == Kind::kIf);
  }
  bool from_end() const { return options_.from_end; }

 private:
  Kind kind_;
  Term term_;
  Options options_;
};

// Arguments: what is wanted, the list, options.
template <Wanted::Kind kKind>
Result<Wanted, Failure> read_wanted(Machine& machine, Arguments arguments) {
  const auto options =
      kKind == Wanted::Kind::kItem
          ? read_options(machine, arguments, 2, {":test", ":test-not", ":key", ":from-end"})
          : read_options(machine, arguments, 2, {":key", ":from-end"});
  if (!options) return tl::unexpected(options.error());
  return Wanted(kKind, arguments[0], *options);
}

constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

struct Hit {
  std::size_t at = kNowhere;
  std::vector<Term> items;
};

template <Wanted::Kind kKind>
Result<Hit, Failure> search(Machine& machine, Arguments arguments) {
  const auto wanted = read_wanted<kKind>(machine, arguments);
  if (!wanted) return tl::unexpected(wanted.error());
  auto items = items_at(machine, arguments, 1);
  if (!items) return tl::unexpected(items.error());
  Hit hit;
  for (std::size_t at = 0; at < items->size(); ++at) {
    const auto match = wanted->is(machine, (*items)[at]);
    if (!match) return tl::unexpected(match.error());
    if (!*match) continue;
    hit.at = at;
    if (!wanted->from_end()) break;
  }
  hit.items = std::move(*items);
  return hit;
}

template <Wanted::Kind kKind>
Outcome find(Machine& machine, Arguments arguments) {
  const auto hit = search<kKind>(machine, arguments);
  if (!hit) return tl::unexpected(hit.error());
  return hit->at == kNowhere ? kNil : hit->items[hit->at];
}

template <Wanted::Kind kKind>
Outcome position(Machine& machine, Arguments arguments) {
  const auto hit = search<kKind>(machine, arguments);
  if (!hit) return tl::unexpected(hit.error());
  if (hit->at == kNowhere) return kNil;
  return machine.store().integer(static_cast<std::int64_t>(hit->at));
}

// The list from the item on.
template <Wanted::Kind kKind>
Outcome member(Machine& machine, Arguments arguments) {
  const auto hit = search<kKind>(machine, arguments);
  if (!hit) return tl::unexpected(hit.error());
  if (hit->at == kNowhere) return kNil;
  return machine.store().list(Arguments(hit->items).subspan(hit->at));
}

template <Wanted::Kind kKind>
Outcome remove(Machine& machine, Arguments arguments) {
  const auto wanted = read_wanted<kKind>(machine, arguments);
  if (!wanted) return tl::unexpected(wanted.error());
  const auto items = items_at(machine, arguments, 1);
  if (!items) return tl::unexpected(items.error());
  std::vector<Term> kept;
  for (const Term item : *items) {
    const auto match = wanted->is(machine, item);
    if (!match) return tl::unexpected(match.error());
    if (!*match) kept.push_back(item);
  }
  return machine.store().list(kept);
}

template <Wanted::Kind kKind>
Outcome count(Machine& machine, Arguments arguments) {
  const auto wanted = read_wanted<kKind>(machine, arguments);
  if (!wanted) return tl::unexpected(wanted.error());
  const auto items = items_at(machine, arguments, 1);
  if (!items) return tl::unexpected(items.error());
  std::int64_t matches = 0;
  for (const Term item : *items) {
    const auto match = wanted->is(machine, item);
    if (!match) return tl::unexpected(match.error());
    if (*match) ++matches;
  }
  return machine.store().integer(matches);
}

// The first pair of an association list whose key (with kValue: value) is wanted.
template <bool kValue>
Outcome assoc(Machine& machine, Arguments arguments) {
  const auto options = read_options(machine, arguments, 2, {":test", ":test-not", ":key"});
  if (!options) return tl::unexpected(options.error());
  const auto items = items_at(machine, arguments, 1);
  if (!items) return tl::unexpected(items.error());
  const Wanted wanted(Wanted::Kind::kItem, arguments[0], *options);
  for (const Term item : *items) {
    if (item == kNil) continue;
    if (!item.is(TermKind::kPair)) return wrong_argument(machine, arguments, 1, "a list of pairs");
    const Term key = kValue ? machine.store().cdr(item) : machine.store().car(item);
    const auto match = wanted.is(machine, key);
    if (!match) return tl::unexpected(match.error());
    if (*match) return item;
  }
  return kNil;
}

// Lists as sets.
struct Sets {
  std::vector<Term> left;
  std::vector<Term> right;
  Options options;

  // Is the term in `others`? The term's key is compared with the keys of the others.
  Result<bool, Failure> contains(Machine& machine, const std::vector<Term>& others,
                                 Term term) const {
    const Outcome key = options.key_of(machine, term);
    if (!key) return tl::unexpected(key.error());
    const Wanted wanted(Wanted::Kind::kItem, *key, options);
    for (const Term other : others) {
      const auto match = wanted.is(machine, other);
      if (!match || *match) return match;
    }
    return false;
  }
};

Result<Sets, Failure> read_sets(Machine& machine, Arguments arguments) {
  const auto options = read_options(machine, arguments, 2, {":test", ":test-not", ":key"});
  if (!options) return tl::unexpected(options.error());
  auto left = items_at(machine, arguments, 0);
  if (!left) return tl::unexpected(left.error());
  auto right = items_at(machine, arguments, 1);
  if (!right) return tl::unexpected(right.error());
  return Sets{std::move(*left), std::move(*right), *options};
}

// Those of `from` that are (kIn) or are not in `others`, the last first: the order in which SBCL,
// the Lisp that SHOP3's results come from, gives them.
template <bool kIn>
Result<std::vector<Term>, Failure> selected(Machine& machine, const Sets& sets,
                                            const std::vector<Term>& from,
                                            const std::vector<Term>& others) {
  std::vector<Term> out;
  for (const Term term : from) {
    const auto contained = sets.contains(machine, others, term);
    if (!contained) return tl::unexpected(contained.error());
    if (*contained == kIn) out.push_back(term);
  }
  std::reverse(out.begin(), out.end());
  return out;
}

template <bool kIn>
Outcome select_left(Machine& machine, Arguments arguments) {
  const auto sets = read_sets(machine, arguments);
  if (!sets) return tl::unexpected(sets.error());
  if (!kIn && sets->right.empty()) return arguments[0];
  const auto out = selected<kIn>(machine, *sets, sets->left, sets->right);
  if (!out) return tl::unexpected(out.error());
  return machine.store().list(*out);
}

Outcome unite(Machine& machine, Arguments arguments) {
  const auto sets = read_sets(machine, arguments);
  if (!sets) return tl::unexpected(sets.error());
  const bool left_shorter = sets->left.size() < sets->right.size();
  const auto& shorter = left_shorter ? sets->left : sets->right;
  const auto& longer = left_shorter ? sets->right : sets->left;
  const auto added = selected<false>(machine, *sets, longer, shorter);
  if (!added) return tl::unexpected(added.error());
  return machine.store().list(*added, arguments[left_shorter ? 0 : 1]);
}

Outcome subsetp(Machine& machine, Arguments arguments) {
  const auto sets = read_sets(machine, arguments);
  if (!sets) return tl::unexpected(sets.error());
  for (const Term term : sets->left) {
    const auto contained = sets->contains(machine, sets->right, term);
    if (!contained) return tl::unexpected(contained.error());
    if (!*contained) return kNil;
  }
  return kTrue;
}

Outcome adjoin(Machine& machine, Arguments arguments) {
  const auto options = read_options(machine, arguments, 2, {":test", ":test-not", ":key"});
  if (!options) return tl::unexpected(options.error());
  auto items = items_at(machine, arguments, 1);
  if (!items) return tl::unexpected(items.error());
  const Sets sets{{}, std::move(*items), *options};
  const auto contained = sets.contains(machine, sets.right, arguments[0]);
  if (!contained) return tl::unexpected(contained.error());
  return *contained ? arguments[1] : machine.store().pair(arguments[0], arguments[1]);
}

// Of equal items the last stays (with :from-end the first). As in SBCL an item goes if it equals
// any behind it, gone or not; from the end, any before it that stays: with a test that is not
// transitive the two differ.
Outcome remove_duplicates(Machine& machine, Arguments arguments) {
  const auto options =
      read_options(machine, arguments, 1, {":test", ":test-not", ":key", ":from-end"});
  if (!options) return tl::unexpected(options.error());
  auto items = items_at(machine, arguments, 0);
  if (!items) return tl::unexpected(items.error());
  if (!options->from_end) std::reverse(items->begin(), items->end());
  const Sets sets{{}, {}, *options};
  std::vector<Term> kept, seen;
  for (const Term item : *items) {
    const auto contained = sets.contains(machine, options->from_end ? kept : seen, item);
    if (!contained) return tl::unexpected(contained.error());
    if (!*contained) kept.push_back(item);
    seen.push_back(item);
  }
  if (!options->from_end) std::reverse(kept.begin(), kept.end());
  return machine.store().list(kept);
}

}  // namespace

std::span<const Builtin> sequence_builtins() {
  static constexpr auto kItem = Wanted::Kind::kItem;
  static constexpr auto kIf = Wanted::Kind::kIf;
  static constexpr auto kIfNot = Wanted::Kind::kIfNot;
  static constexpr std::array kTable{
      Builtin{"member", 2, 6, &member<kItem>},
      Builtin{"member-if", 2, 4, &member<kIf>},
      Builtin{"find", 2, 8, &find<kItem>},
      Builtin{"find-if", 2, 6, &find<kIf>},
      Builtin{"find-if-not", 2, 6, &find<kIfNot>},
      Builtin{"position", 2, 8, &position<kItem>},
      Builtin{"position-if", 2, 6, &position<kIf>},
      Builtin{"position-if-not", 2, 6, &position<kIfNot>},
      Builtin{"count", 2, 8, &count<kItem>},
      Builtin{"count-if", 2, 6, &count<kIf>},
      Builtin{"count-if-not", 2, 6, &count<kIfNot>},
      Builtin{"remove", 2, 8, &remove<kItem>},
      Builtin{"remove-if", 2, 6, &remove<kIf>},
      Builtin{"remove-if-not", 2, 6, &remove<kIfNot>},
      Builtin{"delete", 2, 8, &remove<kItem>},
      Builtin{"delete-if", 2, 6, &remove<kIf>},
      Builtin{"delete-if-not", 2, 6, &remove<kIfNot>},
      Builtin{"assoc", 2, 6, &assoc<false>},
      Builtin{"rassoc", 2, 6, &assoc<true>},
      Builtin{"union", 2, 6, &unite},
      Builtin{"intersection", 2, 6, &select_left<true>},
      Builtin{"set-difference", 2, 6, &select_left<false>},
      Builtin{"subsetp", 2, 6, &subsetp},
      Builtin{"adjoin", 2, 6, &adjoin},
      Builtin{"remove-duplicates", 1, 7, &remove_duplicates},
      Builtin{"delete-duplicates", 1, 7, &remove_duplicates},
  };
  return kTable;
}

}  // namespace skein::htn::lisp
