// SPDX-License-Identifier: Apache-2.0
// The decomposition of a plan of which some steps are executed: what is done, in progress, ahead.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "skein/htn/domain.hpp"
#include "skein/htn_tools/repair.hpp"

namespace skein::htn {

/// A task network to plan, and which node of the old tree each of its tasks stands for, in order.
struct RemainingTasks {
  TaskNetwork network;
  std::vector<TreeIndex> leaves;
};

class OldTree {
 public:
  /// Whether a fact (or (not fact)) was taken away by the last divergence.
  using Gone = std::function<bool(Term)>;

  OldTree(const Plan& plan, StepIndex executed, TermStore& store);
  /// What makes the plan no plan with a tree, if anything; nothing else may be called then.
  const std::string& fault() const { return fault_; }

  /// Says what is done. A task without steps that nothing executed comes after may have to be
  /// looked at again: all of them are taken as ahead, or only those that lost what they rest on.
  void settle(const Gone& gone, bool cautious);

  bool done(TreeIndex node) const { return phases_[node] == Phase::kDone; }
  bool ahead(TreeIndex node) const { return phases_[node] == Phase::kAhead; }
  bool in_progress(TreeIndex node) const { return phases_[node] == Phase::kInProgress; }

  /// The first node, in the order of execution, that needs a fact which is lost.
  std::optional<std::pair<TreeIndex, Term>> first_clobbered(const Gone& gone) const;
  /// The node of a step.
  TreeIndex leaf_of(StepIndex step) const { return leaves_[step]; }
  /// Tasks in progress above a node, the nearest first.
  std::vector<TreeIndex> begun_above(TreeIndex node) const;
  /// The topmost tasks and steps, in order.
  std::vector<TreeIndex> top_tasks() const;

  /// What remains when the tasks `again` are begun again. Nothing if it is nested too deep.
  std::optional<RemainingTasks> remaining(const std::vector<TreeIndex>& again) const;
  /// The choices below these nodes, in the order of execution.
  std::vector<Preference> preferences(const std::vector<TreeIndex>& nodes) const;

 private:
  enum class Phase : std::uint8_t { kDone, kInProgress, kAhead };
  bool check_shape();
  bool check_steps();
  void measure();
  bool idle(TreeIndex node) const { return first_[node] == kNoStep; }
  bool begun(TreeIndex node) const { return !idle(node) && first_[node] < executed_; }
  Phase phase_of(TreeIndex node) const;
  bool lost(const CausalLink& link, const Gone& gone) const;
  std::optional<Term> lost_at(TreeIndex node, const Gone& gone) const;
  std::optional<std::pair<TreeIndex, Term>> lost_below(TreeIndex node, const Gone& gone) const;
  std::vector<TreeIndex> below(TreeIndex node) const;
  void mark_reached();
  void mark_passed();
  void settle_idle(TreeIndex node, Phase phase);
  std::uint32_t order_of(TreeIndex node) const;

  const Plan& plan_;
  StepIndex executed_;
  TermStore& store_;
  std::string fault_;
  std::vector<TreeIndex> top_down_;  // pre-order
  std::vector<TreeIndex> leaves_;    // by step
  std::vector<StepIndex> first_;     // step below; kNoStep: none
  std::vector<StepIndex> last_;
  std::vector<bool> reached_;  // may have been looked at already
  std::vector<bool> passed_;   // something executed comes after it
  std::vector<Phase> phases_;
};

}  // namespace skein::htn
