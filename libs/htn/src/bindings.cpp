// SPDX-License-Identifier: Apache-2.0
#include "bindings.hpp"

#include <algorithm>
#include <array>

namespace skein::htn {

void Bindings::undo(Mark mark) {
  while (trail_.size() > mark.trail) {
    const std::uint32_t cell = trail_.back();
    trail_.pop_back();
    cells_[cell] = Term(TermKind::kVariable, cell);
  }
  cells_.resize(mark.cells);
}

Base Bindings::open(std::uint32_t count) {
  const auto base = static_cast<Base>(cells_.size());
  cells_.resize(base + count);
  for (std::uint32_t cell = base; cell < base + count; ++cell) {
    cells_[cell] = Term(TermKind::kVariable, cell);
  }
  return base;
}

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

Term Bindings::instance(Term term, Base base) {
  if (plain(term)) return term;
  term = resolve(term, base);
  if (!term.is(TermKind::kPair) || plain(term)) return term;
  const std::size_t bottom = open_lists_.size();
  open_lists_.push_back({term, base, items_.size()});
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
  out = plain(term) ? term : resolve(term, base);
  if (plain(out)) return Known::kTerm;
  if (!out.is(TermKind::kPair)) return Known::kOpen;
  std::array<Term, kMostKnownItems> items;
  std::size_t count = 0;
  Term rest = out;
  while (rest.is(TermKind::kPair) && !plain(rest)) {
    if (count == kMostKnownItems || nesting == kMostKnownNesting) {
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
  std::vector<Term> rests{term};
  while (!rests.empty()) {
    const Term next = resolve(rests.back(), base);
    rests.pop_back();
    if (plain(next)) continue;
    if (next.is(TermKind::kPair)) {
      rests.push_back(store_.cdr(next));
      rests.push_back(store_.car(next));
    } else if (std::find(out.begin(), out.end(), next) == out.end()) {
      out.push_back(next);
    }
  }
}

bool Bindings::unify(Term left, Base left_base, Term right, Base right_base) {
  work_.clear();
  work_.push_back({left, left_base, right, right_base});
  while (!work_.empty()) {
    const Pair pair = work_.back();
    work_.pop_back();
    if (!unify_step(pair)) return false;
  }
  return true;
}

bool Bindings::unify_step(const Pair& pair) {
  const Term left = resolve(pair.left, pair.left_base);
  const Term right = resolve(pair.right, pair.right_base);
  if (left.is(TermKind::kVariable)) {
    const bool swap = right.is(TermKind::kVariable) && right.index() > left.index();
    return swap ? bind_checked(right, left, pair.left_base)
                : bind_checked(left, right, pair.right_base);
  }
  if (right.is(TermKind::kVariable)) return bind_checked(right, left, pair.left_base);
  const bool both_plain = plain(left) && plain(right);
  if (both_plain) return left == right;
  if (!left.is(TermKind::kPair) || !right.is(TermKind::kPair)) return false;
  work_.push_back({store_.cdr(left), pair.left_base, store_.cdr(right), pair.right_base});
  work_.push_back({store_.car(left), pair.left_base, store_.car(right), pair.right_base});
  return true;
}

// Younger variables are bound to older ones, so that closing the younger leaves nothing dangling.
bool Bindings::bind_checked(Term variable, Term value, Base base) {
  if (variable == value) return true;
  if (!value.is(TermKind::kPair) || plain(value)) {
    bind(variable, value);
    return true;
  }
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
