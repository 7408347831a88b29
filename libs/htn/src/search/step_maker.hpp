// SPDX-License-Identifier: Apache-2.0
// Applies operators to the state.
#pragma once

#include <string>
#include <vector>

#include "proof/prover.hpp"
#include "search/protections.hpp"

namespace skein::htn {

/// An applied step.
struct MadeStep {
  Term action;
  Number cost;
  std::vector<CausalLink> support;
  StateChange change;  ///< only when changes are recorded
};

/// Applies one operator: first satisfier of its precondition, cost, deletions, additions,
/// protections. Deletions come before additions, both in the reverse order of the text (those of a
/// PDDL action in its order); quantified ones are worked out in the old state; protections are
/// checked last.
class StepMaker {
 public:
  StepMaker(CompiledDomain& domain, Bindings& bindings, FactBase& facts, Protections& protections,
            Prover& prover, Budget& budget)
      : domain_(domain),
        store_(domain.store),
        bindings_(bindings),
        facts_(facts),
        protections_(protections),
        prover_(prover),
        budget_(budget),
        protection_(store_.symbol(":protection")) {}

  /// False when the operator does not apply (why() tells) or the budget stopped; then nothing
  /// changed. `step` is the position in the plan.
  bool apply(const Operator& operation, Term task, StepIndex step, MadeStep& made);
  const char* why() const { return why_; }
  void record_changes(bool on) { recording_ = on; }
  /// Whether the last refusal was due to a precondition without a satisfier.
  bool precondition_failed() const { return precondition_failed_; }

 private:
  bool prepare(const Operator& operation, Term task, Base& base, MadeStep& made);
  bool work_out(const Operator& operation, Base base);
  bool collect(const std::vector<Effect>& effects, Base base, bool negated);
  bool collect(const Effect& effect, Base base, bool negated);
  Term atom_of(const Effect& effect, Base base);
  bool collect_list(Term list, bool negated);
  bool collect_under(const Effect& effect, Base base, bool negated, bool first);
  void collect_atom(Term atom, bool negated);
  bool is_atom(Term term) const;
  bool change_state(StepIndex step);
  void note_change(StateChange& change) const;
  bool protections_hold() const;
  bool refuse(const char* why);
  bool fail(const std::string& why);

  CompiledDomain& domain_;
  TermStore& store_;
  Bindings& bindings_;
  FactBase& facts_;
  Protections& protections_;
  Prover& prover_;
  Budget& budget_;
  Term protection_;   // the word
  Expression where_;  // the operator at work
  Answers answers_;
  std::vector<Term> deleted_;
  std::vector<Term> added_;
  std::vector<Term> released_;
  std::vector<Term> protected_;
  const char* why_ = "";
  bool precondition_failed_ = false;
  bool recording_ = false;
};

}  // namespace skein::htn
