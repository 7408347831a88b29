// SPDX-License-Identifier: Apache-2.0
// Finds the satisfiers of conditions in a state, with axioms.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compile/compiled_domain.hpp"
#include "proof/answers.hpp"
#include "proof/budget.hpp"
#include "proof/evaluator.hpp"
#include "proof/fact_matcher.hpp"
#include "proof/proof_stack.hpp"
#include "proof/value_goals.hpp"

namespace skein::htn {

/// Proves goals depth first with its own stacks: neither recursion of axioms nor the length of a
/// conjunction can overflow. The order of answers is that of SHOP3: for one goal, facts before
/// axioms; the answers of a complete query are the reverse of the order in which they are met;
/// `and`, `or` and `imply` are complete queries of their own whose answers are gone through one
/// after the other. Source: docs/decisions/0006-htn-search.md.
class Prover {
 public:
  Prover(CompiledDomain& domain, Bindings& bindings, FactBase& facts, Budget& budget)
      : domain_(domain),
        store_(domain.store),
        bindings_(bindings),
        facts_(facts),
        budget_(budget),
        stack_(bindings),
        matcher_(domain, bindings, facts),
        evaluator_(domain, bindings, budget),
        value_goals_(domain, bindings, budget) {}

  /// All satisfiers of a condition, or the first found. False if the budget stopped the proof.
  bool solve(ConditionIndex condition, Base base, bool just_one, Answers& out);
  /// All satisfiers of the first goals of a condition (for explanations).
  bool solve_part(ConditionIndex condition, std::size_t goals, Base base, Answers& out);
  /// Whether a ground atom holds, by fact or axiom.
  bool holds(Term atom);

  /// Records which facts each answer rests on.
  void record_support(bool on) { stack_.recording = on; }
  std::size_t memory_bytes() const { return stack_.memory_bytes(); }

 private:
  using Purpose = ProofStack::Purpose;
  using Continuation = ProofStack::Continuation;
  using ContinuationKind = ProofStack::ContinuationKind;
  using Frame = ProofStack::Frame;
  using FrameKind = ProofStack::FrameKind;
  using Query = ProofStack::Query;
  enum class Move : std::uint8_t { kForward, kBack, kDone, kStop };

  bool run();
  Move forward();
  Move back();
  Move emit();
  Move execute(GoalIndex goal, Base base, std::uint32_t after);

  Move begin(Purpose purpose, ConditionIndex condition, bool just_one, Query query);
  Move finish_query();
  Move finish_test(bool holds);
  bool one_is_enough(const Goal& goal, std::uint32_t after) const;
  Move finish_rows(const Query& query);
  Move finish_collection(const Query& query);
  Move finish_quantifier_bounds(const Query& query);
  Move finish_quantifier_part(bool holds, const std::vector<CausalLink>& support);

  Move atom(GoalIndex goal, Base base, std::uint32_t after);
  Move flat_atom(GoalIndex goal, Base base, std::uint32_t after);
  Move first_fact(GoalIndex goal, const FactMatcher::Values& values, Base base,
                  std::uint32_t after);
  Move test_axioms(GoalIndex goal, Base base, std::uint32_t after);
  Move negated(const Goal& goal, Query query);
  Move retry_atom();
  Move try_axioms();
  Move enter_tail(const Axiom& axiom, Base axiom_base);
  Move stop_too_deep(const Axiom& axiom);
  Move leave_atom();
  Move next_row();
  Move next_alternative();
  Move next_item();
  Move quantifier_part();
  Move evaluate(const Goal& goal, Base base, std::uint32_t after);
  Move assign(const Goal& goal, Base base, std::uint32_t after);
  Move assign_each(GoalIndex goal, Base base, std::uint32_t after);
  Move value_as_goal(const Goal& goal, Base base, std::uint32_t after);

  void note_support(FactIndex fact) {
    if (stack_.recording) stack_.support.push_back({facts_.atom(fact), facts_.producer(fact)});
  }
  void note_absence(const Goal& goal, Base base);
  Move fail(const Goal& goal, const std::string& why);

  CompiledDomain& domain_;
  TermStore& store_;
  Bindings& bindings_;
  FactBase& facts_;
  Budget& budget_;
  ProofStack stack_;
  FactMatcher matcher_;
  Evaluator evaluator_;
  ValueGoals value_goals_;
  RowSet seen_;
  std::map<std::pair<ConditionIndex, std::size_t>, ConditionIndex> parts_;  ///< of solve_part
};

}  // namespace skein::htn
