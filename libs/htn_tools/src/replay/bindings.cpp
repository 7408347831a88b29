// SPDX-License-Identifier: Apache-2.0
#include "replay/bindings.hpp"

#include <utility>

namespace skein::htn::replay {

std::uint32_t Bindings::fresh(std::uint32_t count) {
  const auto first = static_cast<std::uint32_t>(values_.size());
  values_.resize(values_.size() + count);
  return first;
}

void Bindings::undo(const Mark& mark) {
  while (trail_.size() > mark.trail) {
    values_[trail_.back()].reset();
    trail_.pop_back();
  }
  values_.resize(mark.variables);
}

Term Bindings::known(Term term, std::uint32_t base) const {
  if (term.is(TermKind::kSlot)) term = {TermKind::kVariable, base + term.index()};
  while (term.is(TermKind::kVariable) && term.index() < values_.size() &&
         values_[term.index()].has_value()) {
    term = *values_[term.index()];
  }
  return term;
}

Term Bindings::rewrite(Term term, std::uint32_t base) const {
  return replace_variables(store_, term, [&](Term variable) { return known(variable, base); });
}

bool Bindings::occurs(Term variable, Term inside) const {
  std::vector<Term> open{inside};
  while (!open.empty()) {
    const Term term = known(open.back(), 0);
    open.pop_back();
    if (term == variable) return true;
    if (term.is(TermKind::kPair) && !store_.ground(term)) {
      open.push_back(store_.car(term));
      open.push_back(store_.cdr(term));
    }
  }
  return false;
}

bool Bindings::bind(Term variable, Term value) {
  if (value.is(TermKind::kPair) && occurs(variable, value)) return false;
  values_[variable.index()] = value;
  trail_.push_back(variable.index());
  return true;
}

bool Bindings::unify(Term left, Term right) {
  std::vector<std::pair<Term, Term>> open{{left, right}};
  while (!open.empty()) {
    const Term one = known(open.back().first, 0);
    const Term other = known(open.back().second, 0);
    open.pop_back();
    if (one == other) continue;
    if (one.is(TermKind::kVariable)) {
      if (!bind(one, other)) return false;
    } else if (other.is(TermKind::kVariable)) {
      if (!bind(other, one)) return false;
    } else if (one.is(TermKind::kPair) && other.is(TermKind::kPair)) {
      open.emplace_back(store_.cdr(one), store_.cdr(other));
      open.emplace_back(store_.car(one), store_.car(other));
    } else if (!alike(store_, one, other)) {
      return false;
    }
  }
  return true;
}

bool alike(const TermStore& store, Term left, Term right) {
  std::vector<std::pair<Term, Term>> open{{left, right}};
  while (!open.empty()) {
    const auto [one, other] = open.back();
    open.pop_back();
    if (one == other) continue;
    if (one.kind() != other.kind()) return false;
    if (one.is(TermKind::kPair)) {
      open.emplace_back(store.cdr(one), store.cdr(other));
      open.emplace_back(store.car(one), store.car(other));
    } else if (!one.is(TermKind::kNumber) || store.to_text(one) != store.to_text(other)) {
      return false;
    }
  }
  return true;
}

// What is open: the items rewritten so far of each list around the current term.
Term replace_variables(TermStore& store, Term term, const std::function<Term(Term)>& value_of) {
  struct Open {
    std::vector<Term> items;
    Term rest;
  };
  const auto is_variable = [](Term some) {
    return some.is(TermKind::kSlot) || some.is(TermKind::kVariable) || some.is(TermKind::kLocal);
  };
  const auto enter = [&](Term some) { return is_variable(some) ? value_of(some) : some; };
  std::vector<Open> open;
  while (true) {
    term = enter(term);
    if (term.is(TermKind::kPair) && !store.ground(term)) {
      open.push_back({{}, store.cdr(term)});
      term = store.car(term);
      continue;
    }
    bool descend = false;
    while (!descend && !open.empty()) {
      open.back().items.push_back(term);
      const Term rest = enter(open.back().rest);
      descend = rest.is(TermKind::kPair) && !store.ground(rest);
      if (descend) {
        open.back().rest = store.cdr(rest);
        term = store.car(rest);
      } else {
        term = store.list(open.back().items, rest);
        open.pop_back();
      }
    }
    if (!descend) return term;
  }
}

}  // namespace skein::htn::replay
