// SPDX-License-Identifier: Apache-2.0
// Proofs of conditions in a state: a small iterative interpreter of Horn clauses.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/bindings.hpp"
#include "replay/clauses.hpp"
#include "replay/world.hpp"

namespace skein::htn::replay {

/// What all proofs of one validation share.
struct ProofContext {
  TermStore& store;
  const Clauses& clauses;
  const World& world;
  Lisp& lisp;
  Bindings& bindings;
  std::uint64_t steps_left;          ///< goals that may still be tried
  std::optional<std::string> error;  ///< set once: a term could not be evaluated, a limit was met
  int nesting = 0;
};

/// Enumerates the proofs of a conjunction, depth first, the newest facts first, facts before
/// axioms. A tail of an axiom counts only if no earlier tail of the same axiom has a proof.
/// Between two calls of next() the bindings are those of the proof found. Only goals inside a
/// negation or a quantifier recurse, and how deep is limited.
class Proof {
 public:
  Proof(ProofContext& context, const std::vector<Goal>& goals, std::uint32_t base);
  /// Of one goal given as a term.
  Proof(ProofContext& context, Term goal);
  bool next();

 private:
  static constexpr std::uint32_t kEnd = 0xFFFFFFFFU;
  enum class Kind : std::uint8_t { kGoal, kTerm, kCommit };
  /// A goal still to be proved; they form chains through `next`.
  struct Pending {
    Kind kind;
    const Goal* goal;
    Term term;           ///< kTerm
    std::uint32_t base;  ///< kGoal: its variables; kCommit: the choice to commit
    std::uint32_t next;
  };
  struct Choice {
    std::uint32_t pending;
    Bindings::Mark mark;
    std::size_t pendings;
    Term atom;
    std::vector<Term> items;  ///< kAssignEach
    std::size_t at = 0;       ///< next fact, alternative or item
    std::size_t axiom = 0;
    std::size_t tail = 0;
    bool committed = false;
    bool once = false;  ///< in a tail with :first: the first proof by way of it is the only one
  };

  std::uint32_t chain(const std::vector<Goal>& goals, std::uint32_t base, std::uint32_t next);
  void keep_once();
  bool step();
  bool step_goal(const Pending& pending);
  bool step_term(const Pending& pending);
  bool backtrack();
  bool choose(Term atom, std::vector<Term> items);
  bool advance(Choice& choice);
  bool advance_atom(Choice& choice, std::uint32_t next);
  bool advance_axiom(std::size_t index, std::uint32_t next);
  bool quantified(const Goal& goal, std::uint32_t base);
  bool collected(const Goal& goal, std::uint32_t base);
  bool assigned(const Goal& goal, std::uint32_t base);

  ProofContext& context_;
  std::vector<Pending> pendings_;
  std::vector<Choice> choices_;
  std::uint32_t current_ = kEnd;
  bool started_ = false;
};

/// Whether there is a proof; bindings are as before.
bool provable(ProofContext& context, const std::vector<Goal>& goals, std::uint32_t base);
bool provable(ProofContext& context, Term goal);

/// The value of a Lisp term of the clause whose variables start at `base`; nil and context.error on
/// failure.
Term evaluate(ProofContext& context, CodeIndex code, std::uint32_t base);

}  // namespace skein::htn::replay
