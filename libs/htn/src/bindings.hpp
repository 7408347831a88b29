// SPDX-License-Identifier: Apache-2.0
// Variables of a search and their values, with undo.
#pragma once

#include <cstdint>
#include <optional>
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
  void undo(Mark mark);
  /// Forgets how to undo: what is bound stays bound for good.
  void forget_trail() { trail_.clear(); }

  Base open(std::uint32_t count);
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
  Term instance(Term term, Base base);
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
  bool unify(Term left, Base left_base, Term right, Base right_base);

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
  bool plain(Term term) const { return (store_.content(term) & (kHasSlot | kHasVariable)) == 0; }
  bool step_list(Open& list);
  bool unify_step(const Pair& pair);
  bool bind_checked(Term variable, Term value, Base base);
  bool occurs(Term variable, Term term, Base base) const;

  TermStore& store_;
  std::vector<Term> cells_;
  std::vector<std::uint32_t> trail_;
  std::vector<Open> open_lists_;
  std::vector<Term> items_;
  std::vector<Pair> work_;
};

}  // namespace skein::htn
