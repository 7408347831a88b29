// SPDX-License-Identifier: Apache-2.0
// The search for plans: task decomposition depth first, on its own stack.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "search/agenda.hpp"
#include "search/explainer.hpp"
#include "search/preferences.hpp"
#include "search/reductions.hpp"
#include "search/step_maker.hpp"
#include "skein/htn/planner.hpp"

namespace skein::htn {

/// The branch of a reduction and, while trees are recorded, the facts that it rests on.
struct ReductionNote {
  const Branch* branch = nullptr;
  std::vector<CausalLink> support;
};

/// A step of the plan under construction.
struct StepRecord {
  Term action;
  Number cost;
  std::vector<CausalLink> support;
  StateChange change;
};

/// The furthest point of a failed search: most steps, then deepest.
struct DeepestPoint {
  std::uint64_t expansion = 0;
  std::size_t steps = 0;
  std::uint64_t depth = 0;
};

/// One run of the search from the initial state. State, bindings, agenda and protections are
/// changed in place and undone on backtracking; when no alternatives remain the trail is dropped,
/// so that a plan found without backtracking needs no memory for it.
class Search {
 public:
  Search(const Domain& domain, const Problem& problem, const Options& options, const Host& host);

  /// Plans of depth below `cutoff` only; plans at depths up to `known_depth` are left out.
  struct Deepening {
    std::optional<std::uint64_t> cutoff;
    std::optional<std::uint64_t> known_depth;
  };
  void run(const Deepening& deepening, Budget& budget);
  /// Replays the events that the problem says have happened; returns their number up to the first
  /// step that does not apply. Part of run().
  std::size_t relive(Budget& budget);
  const FactBase& facts() const { return facts_; }

  std::vector<Plan> plans;
  /// Outcome of a run apart from its plans.
  struct Course {
    std::uint64_t deepest = 0;
    DeepestPoint deepest_failure;
    bool cut_by_depth = false;
    bool negative_cost = false;
    bool too_costly = false;  ///< some partial plan was pruned because of its cost
  };
  const Course& course() const { return course_; }
  /// Stop at the first dead end of this expansion and explain it.
  void explain_at(const DeepestPoint& point) { explain_at_ = point; }
  const std::optional<FailurePoint>& failure() const { return failure_; }
  /// For people: steps done and the next task of an interrupted search; if depth limited it, those
  /// when the limit was first reached.
  std::optional<FailurePoint> standing();
  std::uint64_t repeats() const { return agenda_.repeats(); }
  std::size_t memory_bytes() const;

 private:
  enum class Move : std::uint8_t { kExpand, kBack, kStop };
  enum class ChoiceKind : std::uint8_t { kTask, kMethod };
  struct Choice {
    ChoiceKind kind = ChoiceKind::kTask;
    NodeId node = kNoNodeId;  // kTask: the next to try; kMethod: the one reduced
    std::uint64_t depth = 0;
    Number cost;
    Bindings::Mark bindings;
    FactBase::Mark facts = 0;
    Agenda::Mark agenda;
    Protections::Mark protections = 0;
    ReductionPool::Mark pool;      // before the reductions of this choice
    ReductionPool::Mark pool_end;  // behind them
    std::uint32_t steps = 0;
    std::uint32_t notes = 0;
    std::uint32_t followed = 0;
    std::uint32_t method = 0;     // kMethod: the next to try
    std::uint32_t methods = 0;    // kMethod: how many there are
    std::uint32_t reduction = 0;  // kMethod: the next to try
    std::uint32_t reductions_end = 0;
    std::uint32_t preferred = kAbsent;
    NodeId tried = kNoNodeId;  // kTask: was tried first, out of its turn
    Preferences::Mark preferences = 0;
  };

  Move expand();
  Move back();
  Move attempt(NodeId node);
  Move attempt_step(NodeId node, Term task);
  Move attempt_methods(NodeId node, Term task, std::uint32_t from, std::uint32_t preferred);
  Move take_reduction(NodeId node, std::uint32_t index);
  Reducer::Tell teller(Term task, std::uint32_t method, bool only);
  FailurePoint point_at(NodeId node);
  Move found();
  bool keep(std::uint64_t depth);
  bool enough() const;
  bool acceptable(const Number& cost) const;
  bool affordable(const Number& cost);
  bool follows(Term action);
  Plan make_plan();
  std::vector<TreeNode> make_tree(const std::vector<StepIndex>& renumbered);
  Choice& push_choice(ChoiceKind kind, NodeId node);
  void restore(const Choice& choice);
  void forget();
  void dead_end(NodeId node, Term task);
  void tell(TraceKind kind, Term task, std::string label, std::uint64_t count, std::string detail);
  bool traced(Term task) const;

  bool relive(const Event& event);
  void drop_broken_protections();
  NodeId preferred_node();
  NodeId behind(NodeId node, NodeId tried) const;
  void prefer(Term task, std::size_t first);
  std::uint32_t preferred_method(Term task, const std::vector<Method>& methods) const;

  Explainer explainer() { return {domain_, bindings_, facts_, *prover_, *budget_}; }

  CompiledDomain& domain_;
  TermStore& store_;
  const Options& options_;
  const Host& host_;
  Budget* budget_ = nullptr;
  Bindings bindings_;
  FactBase facts_;
  Agenda agenda_;
  Protections protections_;
  ReductionPool pool_;
  std::optional<Prover> prover_;
  std::optional<Reducer> reducer_;
  std::optional<StepMaker> steps_made_;
  const Problem& problem_;
  std::vector<Choice> choices_;
  std::vector<StepRecord> steps_;
  std::vector<ReductionNote> notes_;
  std::set<Term, bool (*)(Term, Term)> traced_;
  Preferences preferences_;
  Deepening deepening_;
  Number cost_;
  std::optional<Number> best_;
  std::optional<std::uint64_t> cutoff_;
  std::uint32_t followed_ = 0;  ///< steps so far that Options::following knows of
  std::uint64_t depth_ = 0;
  Course course_;
  std::optional<FailurePoint> cut_;  ///< where depth cut it first
  std::optional<DeepestPoint> explain_at_;
  std::optional<FailurePoint> failure_;
};

}  // namespace skein::htn
