// SPDX-License-Identifier: Apache-2.0
// Replaces leaves of terms.
#pragma once

#include <span>
#include <vector>

#include "skein/htn/term_store.hpp"

namespace skein::htn {

/// The term with `leaf` applied to its atoms, into those parts only whose content has one of the
/// bits of `mask`. Without recursion; cost: the size of those parts.
template <class Leaf>
Term map_leaves(TermStore& store, Term term, std::uint8_t mask, Leaf leaf) {
  struct Open {
    Term rest;
    std::size_t start;
  };
  const auto untouched = [&](Term part) { return (store.content(part) & mask) == 0; };
  if (untouched(term)) return term;
  if (!term.is(TermKind::kPair)) return leaf(term);
  std::vector<Open> open{{term, 0}};
  std::vector<Term> items;
  while (true) {
    const Term rest = open.back().rest;
    if (rest.is(TermKind::kPair) && !untouched(rest)) {
      const Term item = store.car(rest);
      open.back().rest = store.cdr(rest);
      if (untouched(item)) {
        items.push_back(item);
      } else if (item.is(TermKind::kPair)) {
        open.push_back({item, items.size()});
      } else {
        items.push_back(leaf(item));
      }
      continue;
    }
    const std::size_t start = open.back().start;
    open.pop_back();
    const Term tail = untouched(rest) ? rest : leaf(rest);
    const Term made = store.list(std::span(items).subspan(start), tail);
    items.resize(start);
    if (open.empty()) return made;
    items.push_back(made);
  }
}

}  // namespace skein::htn
