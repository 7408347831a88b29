// SPDX-License-Identifier: Apache-2.0
// Variables of a search and their values, with undo.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "skein/htn/term_store.hpp"

namespace skein::htn {

/// First cell of an activation of a clause: slot s of the clause is cell base + s.
using Base = std::uint32_t;

/// Cells hold the values of variables. A clause is activated by opening as many cells as it has
/// slots; undoing closes them again. Terms with slots (patterns) are read under the base of their
/// activation, so that nothing is copied until an instance is needed.
class Bindings {
 public:
  explicit Bindings(TermStore& store) : store_(store) {}

  struct Mark {
    std::uint32_t cells = 0;
    std::uint32_t trail = 0;
  };
  Mark mark() const {
    return {static_cast<std::uint32_t>(cells_.size()), static_cast<std::uint32_t>(trail_.size())};
  }
  /// Unbinds what was bound and closes the cells opened since.
  void undo(Mark mark) {
    while (trail_.size() > mark.trail) {
      const std::uint32_t cell = trail_.back();
      trail_.pop_back();
      cells_[cell] = Term(TermKind::kVariable, cell);
    }
    cells_.erase(cells_.begin() + mark.cells, cells_.end());
  }
  /// Forgets how to undo: what is bound stays bound for good.
  void forget_trail() { trail_.clear(); }

  Base open(std::uint32_t count) {
    const auto base = static_cast<Base>(cells_.size());
    for (std::uint32_t cell = base; cell < base + count; ++cell) {
      cells_.emplace_back(TermKind::kVariable, cell);
    }
    return base;
  }
  /// Opens the cells of a clause and unifies what it wants, a list, with what is given, which is
  /// read under `given_base`. `items` are those of `wanted`, or nothing if it is no proper list:
  /// slots among them that stand alone take their values as they are opened. False leaves cells
  /// and bindings to be undone.
  bool enter(std::uint32_t slots, Term wanted, std::span<const Term> items, Term given,
             Base given_base, Base& base) {
    base = open(slots);
    if (items.empty()) return unify(given, given_base, wanted, base);
    Term rest = given;
    for (const Term item : items) {
      if (!rest.is(TermKind::kPair)) return rest != kNil && unify(given, given_base, wanted, base);
      const Term value = resolve(store_.car(rest), given_base);
      const std::uint32_t cell = base + item.index();
      const bool fresh =
          item.is(TermKind::kSlot) && cells_[cell] == Term(TermKind::kVariable, cell);
      if (fresh && plain(value)) {
        cells_[cell] = value;  // nobody needs to undo it: the cell is closed
      } else if (!unify(value, given_base, item, base)) {
        return false;
      }
      rest = store_.cdr(rest);
    }
    return rest == kNil || unify(given, given_base, wanted, base);
  }
  /// Closes the cells from `first` on although older variables were bound since `mark`: drops the
  /// closed cells from the trail and makes the values bound to older cells independent of them.
  /// Cells that such values still mention stay open.
  void close(Mark mark);

  /// Follows slots and bound variables; the result is an unbound variable or any other term,
  /// whose inside is not followed.
  Term resolve(Term term, Base base) const {
    if (term.is(TermKind::kSlot)) term = Term(TermKind::kVariable, base + term.index());
    while (term.is(TermKind::kVariable)) {
      const Term value = cells_[term.index()];
      if (value == term) return term;
      term = value;
    }
    return term;
  }
  /// The term with all slots and bound variables replaced. Cost: its size, nothing if ground.
  Term instance(Term term, Base base) {
    if (!term.is(TermKind::kPair)) term = resolve(term, base);
    return !term.is(TermKind::kPair) || plain(term) ? term : made_list(term, base, 0);
  }
  /// Without slots and variables of the search.
  bool plain(Term term) const {
    if (term.is(TermKind::kPair)) return (store_.content(term) & (kHasSlot | kHasVariable)) == 0;
    return !term.is(TermKind::kSlot) && !term.is(TermKind::kVariable);
  }
  /// What is known of an instance without making it.
  enum class Known : std::uint8_t {
    kTerm,   ///< ground, and a term of the store
    kNever,  ///< it has a ground part that the store never met: it can equal no fact
    kOpen    ///< it has unbound variables
  };
  /// Looks an instance up without making a term of every question; large or deep terms are made
  /// all the same. `out` is set for kTerm.
  Known look_up(Term term, Base base, Term& out, int nesting = 0);

  void bind(Term variable, Term value) {
    cells_[variable.index()] = value;
    trail_.push_back(variable.index());
  }
  /// Most general unifier with occurs check; false leaves bindings made on the way (the caller
  /// undoes to its own mark). Works without recursion.
  bool unify(Term left, Base left_base, Term right, Base right_base) {
    const Pair pair = resolved({left, left_base, right, right_base});
    return two_lists(pair) ? unify_lists(pair) : unify_leaves(pair);
  }

  /// Appends the unbound variables inside the term that `out` does not hold yet.
  void collect_unbound(Term term, Base base, std::vector<Term>& out) const;

  /// Cells below `cells` bound since trail position `from`.
  template <class Visit>
  void for_each_bound_since(Mark mark, Visit visit) const {
    for (std::size_t at = mark.trail; at < trail_.size(); ++at) {
      if (trail_[at] < mark.cells) visit(Term(TermKind::kVariable, trail_[at]));
    }
  }
  std::size_t memory_bytes() const {
    return cells_.capacity() * sizeof(Term) + trail_.capacity() * sizeof(std::uint32_t);
  }
  TermStore& store() const { return store_; }

 private:
  struct Open {  // a list in the making: items from `start` of items_, `rest` still to read
    Term rest;
    Base base;
    std::size_t start;
  };
  struct Pair {
    Term left;
    Base left_base;
    Term right;
    Base right_base;
  };
  static constexpr std::size_t kMostKnownItems = 24;
  static constexpr int kMostKnownNesting = 8;
  static constexpr std::size_t kMostItemsAtOnce = 12;
  Term made_list(Term list, Base base, int nesting);
  Term made_deep_list(Term list, Base base);
  bool step_list(Open& list);
  Pair resolved(Pair pair) const {
    pair.left = resolve(pair.left, pair.left_base);
    pair.right = resolve(pair.right, pair.right_base);
    return pair;
  }
  // Lists to be compared item by item.
  bool two_lists(const Pair& pair) const {
    return pair.left.is(TermKind::kPair) && pair.right.is(TermKind::kPair) &&
           !(plain(pair.left) && plain(pair.right));
  }
  bool unify_lists(Pair pair);
  bool unify_leaves(const Pair& pair) {
    if (pair.left.is(TermKind::kVariable)) {
      const bool younger =
          pair.right.is(TermKind::kVariable) && pair.right.index() > pair.left.index();
      return younger ? bind_checked(pair.right, pair.left, pair.left_base)
                     : bind_checked(pair.left, pair.right, pair.right_base);
    }
    if (pair.right.is(TermKind::kVariable)) {
      return bind_checked(pair.right, pair.left, pair.left_base);
    }
    return pair.left == pair.right;
  }
  // Younger variables are bound to older ones, so that closing the younger leaves nothing dangling.
  bool bind_checked(Term variable, Term value, Base base) {
    if (value.is(TermKind::kPair) && !plain(value)) return bind_list(variable, value, base);
    if (variable != value) bind(variable, value);
    return true;
  }
  bool bind_list(Term variable, Term value, Base base);
  bool occurs(Term variable, Term term, Base base) const;

  TermStore& store_;
  std::vector<Term> cells_;
  std::vector<std::uint32_t> trail_;
  std::vector<Open> open_lists_;
  std::vector<Term> items_;
  std::vector<Pair> work_;
};

}  // namespace skein::htn
