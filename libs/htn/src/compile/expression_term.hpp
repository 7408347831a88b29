// SPDX-License-Identifier: Apache-2.0
// From text as read to terms.
#pragma once

#include <span>
#include <vector>

#include "skein/htn/definitions.hpp"

namespace skein::htn {

/// What term_of works with; kept by callers that make many terms.
struct TermScratch {
  struct Open {  // a list whose items are being read
    NodeIndex next;
    bool dotted;
    std::size_t start;
  };
  std::vector<Open> open;
  std::vector<Term> items;
};

/// The term an expression writes, with `leaf` applied to its symbols, numbers and strings. Works
/// without recursion.
template <class Leaf>
Term term_of(Expression expression, TermStore& store, Leaf leaf, TermScratch& scratch) {
  const Document& document = *expression.document;
  auto& [open, items] = scratch;
  open.clear();
  items.clear();
  NodeIndex at = expression.node;
  while (true) {
    const Node& node = document[at];
    if (node.list && node.first_child != kNoNode) {
      open.push_back({node.first_child, node.dotted, items.size()});
    } else {
      items.push_back(node.list ? kNil : leaf(node.atom));
    }
    while (!open.empty() && open.back().next == kNoNode) {
      const TermScratch::Open done = open.back();
      open.pop_back();
      Term tail = kNil;
      if (done.dotted) {
        tail = items.back();
        items.pop_back();
      }
      const Term made = store.list(std::span(items).subspan(done.start), tail);
      items.resize(done.start);
      items.push_back(made);
    }
    if (open.empty()) return items.back();
    at = open.back().next;
    open.back().next = document[at].next;
  }
}

}  // namespace skein::htn
