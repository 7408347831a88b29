// SPDX-License-Identifier: Apache-2.0
// The decomposition of a partly executed plan: tasks done, in progress, and ahead.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "skein/htn/domain.hpp"
#include "skein/htn_tools/repair.hpp"

namespace skein::htn {

/// A task network to plan, with the node of the old tree for each of its tasks, in order.
struct RemainingTasks {
  TaskNetwork network;
  std::vector<TreeIndex> leaves;
};

class OldTree {
 public:
  /// Whether the last divergence made a fact (or (not fact)) false.
  using Gone = std::function<bool(Term)>;

  OldTree(const Plan& plan, StepIndex executed, TermStore& store);
  /// Fault of the plan's tree, empty if there is none; with a fault no other method may be called.
  const std::string& fault() const { return fault_; }

  /// Determines the phase of each task. Tasks without steps that no executed step follows are
  /// uncertain: with `cautious` all of them count as ahead, else only those that lost their
  /// support.
  void settle(const Gone& gone, bool cautious);

  bool done(TreeIndex node) const { return phases_[node] == Phase::kDone; }
  bool ahead(TreeIndex node) const { return phases_[node] == Phase::kAhead; }
  bool in_progress(TreeIndex node) const { return phases_[node] == Phase::kInProgress; }

  /// The first node, in the order of execution, that needs a lost fact.
  std::optional<std::pair<TreeIndex, Term>> first_clobbered(const Gone& gone) const;
  /// The node of a step.
  TreeIndex leaf_of(StepIndex step) const { return leaves_[step]; }
  /// Tasks in progress above a node, the nearest first.
  std::vector<TreeIndex> begun_above(TreeIndex node) const;
  /// The topmost tasks and steps, in order.
  std::vector<TreeIndex> top_tasks() const;

  /// The remaining tasks if those in `again` are begun again. Nothing if nested too deep.
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
