// SPDX-License-Identifier: Apache-2.0
// The state of the world during a search: facts, newest first, with indexes and undo.
#pragma once

#include <tsl/robin_map.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "compile/indexed_position.hpp"
#include "skein/htn/plan.hpp"
#include "skein/htn/term_store.hpp"

namespace skein::htn {

using FactIndex = std::uint32_t;
inline constexpr FactIndex kNoFact = 0xFFFFFFFFU;

/// The neighbours of a fact in a list of facts.
struct FactLink {
  FactIndex previous = kNoFact;
  FactIndex next = kNoFact;
};

/// Facts in force, per predicate as a list with the newest first, as SHOP3's `:mixed` states have
/// them: a fact whose deletion is undone comes back at the front. Indexes are made when a goal
/// first asks for one: for the arguments, and for the items of arguments that are lists.
class FactBase {
 public:
  explicit FactBase(TermStore& store) : store_(store) {}

  /// Adds an atom unless one that is `equalp` is there. `producer` becomes the origin of the atom,
  /// if it was there already too.
  void add(Term atom, StepIndex producer);
  /// Deletes the atom if it is there.
  void remove(Term atom, StepIndex deleter);
  bool holds(Term atom) const { return find(atom) != kNoFact; }
  FactIndex find(Term atom) const;
  /// The same for a predicate and its arguments, without a term for the atom.
  FactIndex find(Term predicate, std::span<const Term> arguments) const;
  /// A fact of these arguments that is in force or was once; kNoFact.
  FactIndex record_of(Term predicate, std::span<const Term> arguments) const;
  /// Any fact in force.
  bool any(Term predicate) const {
    const Predicate* facts = known_predicate(predicate);
    return facts != nullptr && facts->all.count > 0;
  }

  using Mark = std::uint32_t;
  Mark mark() const { return static_cast<Mark>(trail_.size()); }
  void undo(Mark mark);
  void forget_trail() { trail_.clear(); }

  /// A list of facts in force: those of a predicate or of one bucket of one of its indexes.
  struct Cursor {
    FactIndex fact = kNoFact;
    const std::vector<FactLink>* links = nullptr;
  };
  Cursor all(Term predicate) const;
  struct Candidates {
    Cursor first;
    std::uint32_t count = 0;
  };
  /// The shortest list that holds every fact which may match: `known` gives the value of a
  /// position, if it has one.
  template <class Known>
  Candidates candidates(Term predicate, std::span<const IndexedPosition> positions, Known known);
  Cursor next(Cursor cursor) const;

  std::span<const Term> arguments(FactIndex fact) const {
    const Fact& record = facts_[fact];
    return {arguments_.data() + record.arguments, record.argument_count};
  }
  Term atom(FactIndex fact) const { return facts_[fact].atom; }
  StepIndex producer(FactIndex fact) const { return facts_[fact].producer; }
  /// The step that deleted the atom last; kInitialState if none did. Known while recording.
  StepIndex deleter(Term atom) const;
  void record_deleters() { recording_ = true; }

  std::vector<Term> atoms() const;
  std::size_t memory_bytes() const;

 private:
  struct Fact {
    Term atom;
    std::uint32_t predicate = 0;
    std::uint32_t local = 0;  // position among all facts ever seen of the predicate
    std::uint32_t arguments = 0;
    std::uint32_t argument_count = 0;
    StepIndex producer = kInitialState;
    bool in_force = false;
  };
  struct Bucket {
    std::uint32_t head = kNoFact;
    std::uint32_t count = 0;
  };
  struct Index {
    Path path;
    tsl::robin_map<std::uint32_t, std::uint32_t> numbers;  // of buckets, by the bits of the value
    std::vector<Bucket> buckets;
    std::vector<std::uint32_t> bucket_of;  // by Fact::local; kNoFact: nothing stands there
    std::vector<FactLink> links;           // by Fact::local
  };
  struct Predicate {
    Bucket all;
    std::vector<FactLink> links;
    std::vector<FactIndex> facts;                 // by Fact::local
    std::vector<std::unique_ptr<Index>> indexes;  // never moved: cursors point into them
  };
  enum class Change : std::uint8_t { kAdded, kRemoved, kProducer, kDeleter, kSpelling };
  struct Undo {
    Change change;
    std::uint32_t fact;
    std::uint32_t earlier;  // producer, deleter, or the pair that was the atom
  };
  static constexpr std::uint32_t kFewFacts = 6;

  FactIndex fact_of(Term atom);
  Predicate& predicate_of(Term symbol);
  const Predicate* known_predicate(Term symbol) const {
    if (symbol.index() >= predicate_of_symbol_.size()) return nullptr;
    const std::uint32_t index = predicate_of_symbol_[symbol.index()];
    return index == kNoFact ? nullptr : &predicates_[index];
  }
  void enter(FactIndex fact);
  void grow_table();
  void insert(FactIndex fact);
  void erase(FactIndex fact);
  void link(Bucket& bucket, std::vector<FactLink>& links, const Fact& fact, FactIndex index);
  void unlink(Bucket& bucket, std::vector<FactLink>& links, const Fact& fact);
  std::optional<Term> value_at(const Fact& fact, Path path) const;
  std::uint32_t bucket_for(Index& index, const Fact& fact) const;
  Index& index_for(Predicate& predicate, Path path);
  void set_producer(FactIndex fact, StepIndex producer);
  void spell(FactIndex fact, Term atom);

  TermStore& store_;
  std::vector<Fact> facts_;
  std::vector<Term> arguments_;
  std::vector<std::uint32_t> fact_of_pair_;  // by the index of the loose atom; kNoFact
  std::vector<std::uint32_t> table_;  // facts by their arguments: open addressing; 0: free, else
                                      // index + 1. A fact stays under spellings it had before.
  std::size_t entries_ = 0;
  std::vector<std::uint32_t> predicate_of_symbol_;
  std::vector<Predicate> predicates_;
  std::vector<Undo> trail_;
  std::vector<StepIndex> deleter_;  // by fact, while recording
  bool recording_ = false;
};

template <class Known>
FactBase::Candidates FactBase::candidates(Term predicate,
                                          std::span<const IndexedPosition> positions, Known known) {
  const Predicate* facts = known_predicate(predicate);
  if (facts == nullptr || facts->all.count == 0) return {};
  Candidates best{{facts->all.head, &facts->links}, facts->all.count};
  for (const IndexedPosition& position : positions) {
    if (best.count <= kFewFacts) break;
    const std::optional<Term> value = known(position);
    if (!value) continue;
    Index& index = index_for(predicate_of(predicate), position.path);
    const auto number = index.numbers.find(value->bits());
    if (number == index.numbers.end()) return {};
    const Bucket& bucket = index.buckets[number->second];
    if (bucket.count == 0) return {};
    if (bucket.count >= best.count) continue;
    best = {{bucket.head, &index.links}, bucket.count};
  }
  return best;
}

inline FactBase::Cursor FactBase::next(Cursor cursor) const {
  return {(*cursor.links)[facts_[cursor.fact].local].next, cursor.links};
}

}  // namespace skein::htn
