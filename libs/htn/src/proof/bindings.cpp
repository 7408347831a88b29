// SPDX-License-Identifier: Apache-2.0
#include "proof/bindings.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace skein::htn {

void Bindings::close(Mark mark) {
  std::uint32_t keep = mark.cells;
  std::size_t kept = mark.trail;
  for (std::size_t at = mark.trail; at < trail_.size(); ++at) {
    const std::uint32_t cell = trail_[at];
    if (cell >= mark.cells) continue;
    const Term value = instance(cells_[cell], 0);
    cells_[cell] = value;
    trail_[kept++] = cell;
    if (plain(value)) continue;
    std::vector<Term> inside;
    collect_unbound(value, 0, inside);
    for (const Term variable : inside) keep = std::max(keep, variable.index() + 1);
  }
  trail_.resize(kept);
  cells_.resize(keep);
}

// Lists are made from their last item on; long and deep ones with a stack of their own.
Term Bindings::made_list(Term list, Base base, int nesting) {
  if (nesting == kMostKnownNesting) return made_deep_list(list, base);
  std::array<Term, kMostItemsAtOnce> items;
  std::size_t count = 0;
  Term rest = list;
  while (rest.is(TermKind::kPair) && !plain(rest)) {
    if (count == kMostItemsAtOnce) {
      rest = made_list(rest, base, nesting + 1);
      break;
    }
    Term item = store_.car(rest);
    if (!item.is(TermKind::kPair)) item = resolve(item, base);
    if (item.is(TermKind::kPair) && !plain(item)) item = made_list(item, base, nesting + 1);
    items[count++] = item;
    rest = resolve(store_.cdr(rest), base);
  }
  while (count > 0) rest = store_.pair(items[--count], rest);
  return rest;
}

Term Bindings::made_deep_list(Term list, Base base) {
  const std::size_t bottom = open_lists_.size();
  open_lists_.push_back({list, base, items_.size()});
  while (true) {
    if (step_list(open_lists_.back())) continue;
    const Open done = open_lists_.back();
    open_lists_.pop_back();
    const Term made = store_.list(std::span(items_).subspan(done.start), done.rest);
    items_.resize(done.start);
    if (open_lists_.size() == bottom) return made;
    items_.push_back(made);
  }
}

// Reads one more item of the list, opening it if it is a list with variables itself. False when
// what remains can stand as the tail.
bool Bindings::step_list(Open& list) {
  list.rest = resolve(list.rest, list.base);
  if (!list.rest.is(TermKind::kPair) || plain(list.rest)) return false;
  const Term item = resolve(store_.car(list.rest), list.base);
  list.rest = store_.cdr(list.rest);
  if (item.is(TermKind::kPair) && !plain(item)) {
    open_lists_.push_back({item, list.base, items_.size()});
  } else {
    items_.push_back(item);
  }
  return true;
}

Bindings::Known Bindings::look_up(Term term, Base base, Term& out, int nesting) {
  out = term.is(TermKind::kPair) ? term : resolve(term, base);
  if (plain(out)) return Known::kTerm;
  if (!out.is(TermKind::kPair)) return Known::kOpen;
  std::array<Term, kMostItemsAtOnce> items;
  std::size_t count = 0;
  Term rest = out;
  while (rest.is(TermKind::kPair) && !plain(rest)) {
    if (count == kMostItemsAtOnce || nesting == kMostKnownNesting) {
      out = instance(term, base);
      return plain(out) ? Known::kTerm : Known::kOpen;
    }
    const Known known = look_up(store_.car(rest), base, items[count++], nesting + 1);
    if (known != Known::kTerm) return known;
    rest = resolve(store_.cdr(rest), base);
  }
  if (!plain(rest)) return Known::kOpen;
  while (count > 0) {
    const std::optional<Term> made = store_.find_pair(items[--count], rest);
    if (!made) return Known::kNever;
    rest = *made;
  }
  out = rest;
  return Known::kTerm;
}

void Bindings::collect_unbound(Term term, Base base, std::vector<Term>& out) const {
  const Term value = resolve(term, base);
  if (!value.is(TermKind::kPair)) {
    if (!plain(value) && std::find(out.begin(), out.end(), value) == out.end())
      out.push_back(value);
    return;
  }
  if (plain(value)) return;
  std::vector<Term> rests;  // of lists around the one that is gone along
  for (Term next = value;;) {
    if (!plain(next)) {
      if (next.is(TermKind::kPair)) {
        const Term rest = store_.cdr(next);
        if (rest != kNil) rests.push_back(rest);
        next = resolve(store_.car(next), base);
        continue;
      }
      if (std::find(out.begin(), out.end(), next) == out.end()) out.push_back(next);
    }
    if (rests.empty()) return;
    next = resolve(rests.back(), base);
    rests.pop_back();
  }
}

// Along the lists; where items are lists themselves, what follows them waits.
bool Bindings::unify_lists(Pair pair) {
  work_.clear();
  while (true) {
    while (two_lists(pair)) {
      const Pair items = resolved(
          {store_.car(pair.left), pair.left_base, store_.car(pair.right), pair.right_base});
      const Pair rests{store_.cdr(pair.left), pair.left_base, store_.cdr(pair.right),
                       pair.right_base};
      if (two_lists(items)) {
        work_.push_back(rests);
        pair = items;
      } else {
        if (!unify_leaves(items)) return false;
        pair = resolved(rests);
      }
    }
    if (!unify_leaves(pair)) return false;
    if (work_.empty()) return true;
    pair = resolved(work_.back());
    work_.pop_back();
  }
}

bool Bindings::bind_list(Term variable, Term value, Base base) {
  if (occurs(variable, value, base)) return false;
  bind(variable, instance(value, base));
  return true;
}

bool Bindings::occurs(Term variable, Term term, Base base) const {
  std::vector<Term> unbound;
  collect_unbound(term, base, unbound);
  return std::find(unbound.begin(), unbound.end(), variable) != unbound.end();
}

}  // namespace skein::htn
