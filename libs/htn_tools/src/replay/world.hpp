// SPDX-License-Identifier: Apache-2.0
// The state of a replay: facts in the order they came, and counted protections.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "skein/htn/term_store.hpp"

namespace skein::htn::replay {

class World {
 public:
  explicit World(const TermStore& store) : store_(store) {}

  /// Of one predicate, oldest first.
  const std::vector<Term>& facts(Term predicate) const;
  bool holds(Term fact) const;
  /// Nothing happens where the fact holds already, or does not hold.
  void add(Term fact);
  void remove(Term fact);
  void protect(Term goal);
  void release(Term goal);
  /// What is protected now, each once.
  std::vector<Term> protections() const;

  std::size_t mark() const { return changes_.size(); }
  void undo(std::size_t mark);

 private:
  enum class Kind : std::uint8_t { kAdded, kRemoved, kProtected, kReleased };
  struct Change {
    Kind kind;
    Term term;
    std::size_t place;  ///< where a removed fact was
  };
  struct Protection {
    Term goal;
    int count = 0;
  };
  void change_count(Term goal, int by);
  std::size_t find(const std::vector<Term>& facts, Term fact) const;

  const TermStore& store_;
  std::map<std::uint32_t, std::vector<Term>> facts_;  // by the bits of the predicate
  std::map<std::uint32_t, Protection> protections_;   // by the bits of the goal
  std::vector<Change> changes_;
};

/// The name a fact or a goal starts with.
inline Term predicate_of(const TermStore& store, Term fact) {
  return fact.is(TermKind::kPair) ? store.car(fact) : fact;
}

}  // namespace skein::htn::replay
