// SPDX-License-Identifier: Apache-2.0
#include "lisp/source.hpp"

#include <algorithm>

namespace skein::htn::lisp {

std::vector<NodeIndex> Source::children(NodeIndex index) const {
  return htn::children(document_, index);
}

std::string_view Source::symbol(NodeIndex index) const {
  return is_symbol(index) ? program_.store().name(node(index).atom) : std::string_view{};
}

bool Source::is_symbol(NodeIndex index) const {
  return !node(index).list && node(index).atom.is(TermKind::kSymbol);
}

bool Source::is_form(NodeIndex index, std::string_view head) const {
  const NodeIndex first = node(index).first_child;
  return node(index).list && first != kNoNode && symbol(first) == head;
}

bool Source::is_variable_name(NodeIndex at) const {
  return is_symbol(at) && node(at).atom != kNil && node(at).atom != kTrue &&
         !symbol(at).starts_with(':') && !symbol(at).starts_with('&');
}

bool Source::contains_call(NodeIndex index) const {
  std::vector<NodeIndex> open{index};
  while (!open.empty()) {
    const NodeIndex at = open.back();
    open.pop_back();
    if (!node(at).list) continue;
    if (is_form(at, "call")) return true;
    for (NodeIndex child = node(at).first_child; child != kNoNode; child = node(child).next) {
      open.push_back(child);
    }
  }
  return false;
}

// An explicit stack, as data may be deep: the finished items of each list that is open.
Term Source::datum(NodeIndex at) const {
  struct Open {
    std::vector<Term> items;
    NodeIndex list = kNoNode;
  };
  std::vector<Open> open;
  while (true) {
    const Node& current = node(at);
    if (current.list && current.first_child != kNoNode) {
      open.push_back({{}, at});
      at = current.first_child;
      continue;
    }
    Term done = current.list ? kNil : datum_atom(at);
    NodeIndex next = current.next;
    while (!open.empty()) {
      Open& last = open.back();
      last.items.push_back(done);
      if (next != kNoNode) break;
      const bool dotted = node(last.list).dotted;
      const Arguments items(last.items);
      done = dotted ? program_.store().list(items.first(items.size() - 1), items.back())
                    : program_.store().list(items);
      next = node(last.list).next;
      open.pop_back();
    }
    if (open.empty()) return done;
    at = next;
  }
}

Term Source::datum_atom(NodeIndex at) const {
  const Term term = node(at).atom;
  if (!is_symbol(at) || !symbol(at).starts_with('?') || !slot_of_) return term;
  const auto slot = slot_of_(term);
  return slot ? Term(TermKind::kSlot, *slot) : term;
}

void Source::error(NodeIndex at, std::string message, std::string expected, std::string nearest) {
  const Place place = place_of(document_, node(at).begin);
  errors_.add(clipped({document_.file,
                       place.line,
                       place.column,
                       {},
                       std::move(message),
                       std::move(expected),
                       std::move(nearest)}));
}

void Source::check_count(NodeIndex at, std::string_view name, std::size_t given, std::size_t least,
                         std::size_t most) {
  if (given >= least && given <= most) return;
  error(at, "'" + std::string(name) + "' with " + count_text(given, given),
        count_text(least, most));
}

}  // namespace skein::htn::lisp
