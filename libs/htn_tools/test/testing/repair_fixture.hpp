// SPDX-License-Identifier: Apache-2.0
// Plans a problem, repairs the plan, and checks the outcome with the validator.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/htn/definitions.hpp"
#include "skein/htn_tools/repair.hpp"

namespace skein::htn::testing {

class RepairFixture {
 public:
  /// A file with one domain `d` and one problem.
  explicit RepairFixture(const std::string& text);
  RepairFixture(const RepairFixture&) = delete;
  RepairFixture& operator=(const RepairFixture&) = delete;

  /// The first plan, with its tree; empty steps and tree if there is none.
  const Plan& make_plan(const Limits& limits = {});
  const Plan& plan() const { return plan_; }
  /// "(at a)": a fact that came about; "-(at a)": one that was lost.
  RepairFixture& diverge(StepIndex after, const std::vector<std::string>& changes);
  RepairFixture& diverge(StepIndex after, const std::vector<Change>& changes);
  const Repair& repair(StepIndex executed, const RepairOptions& options = {},
                       const Host& host = {});
  /// Takes the repaired plan as the one under execution.
  void adopt() { plan_ = repair_.plan; }
  void forget_tree() { plan_.tree.clear(); }

  /// Replays the repaired plan with the divergences at their places and checks its tree; a
  /// sentence, "" if all is well. The validator sees divergences as steps of their own.
  std::string fault(bool with_tree = true) const;
  /// The same for the plan before it was repaired.
  std::string plan_fault() const { return fault_of(plan_, {}, true); }
  /// The actions as text: of the repaired plan behind the executed steps, or any of a plan.
  std::vector<std::string> rest() const;
  std::vector<std::string> actions(const Plan& plan, StepIndex from = 0) const;
  std::vector<std::string> actions(const Plan& plan, const std::vector<StepIndex>& steps) const;
  std::string text(Term term) const { return store_.to_text(term); }
  std::vector<std::string> redone() const;
  /// Everything, for messages.
  std::string describe() const;
  TermStore& store() { return store_; }
  const Problem& problem() const { return problem_; }

 private:
  Term term(const std::string& text);
  std::string fault_of(const Plan& plan, const std::vector<Divergence>& divergences,
                       bool with_tree) const;

  mutable TermStore store_;
  std::string text_;
  Functions host_;
  Definitions definitions_;
  std::shared_ptr<Domain> domain_;
  Problem problem_;
  Plan plan_;
  std::vector<Divergence> divergences_;
  StepIndex executed_ = 0;
  Repair repair_;
};

}  // namespace skein::htn::testing
