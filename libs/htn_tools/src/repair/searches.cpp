// SPDX-License-Identifier: Apache-2.0
#include "repair/searches.hpp"

#include <algorithm>
#include <map>

#include "repair/repaired_plan.hpp"
#include "repair/tree_walk.hpp"
#include "skein/htn/term_map.hpp"

namespace skein::htn {

namespace {

constexpr std::uint64_t kFirstEffort = 200;  // expansions, and some for each node of the old tree
constexpr std::uint64_t kEffortPerNode = 4;
constexpr std::uint64_t kMoreEffort = 16;
constexpr std::uint64_t kInferencesPerExpansion = 500;

void collect_leaves(TaskNetwork& network, std::vector<TaskNetwork*>& out) {
  if (network.kind == NetworkKind::kTask) out.push_back(&network);
  for (TaskNetwork& child : network.children) collect_leaves(child, out);
}

// What the variables of a task were bound to, as its instance shows.
void match(const TermStore& store, Term task, Term instance, std::map<std::uint32_t, Term>& out) {
  std::vector<std::pair<Term, Term>> open{{task, instance}};
  while (!open.empty()) {
    const auto [pattern, value] = open.back();
    open.pop_back();
    if (pattern.is(TermKind::kLocal) && store.ground(value)) out[pattern.index()] = value;
    if (!pattern.is(TermKind::kPair) || !value.is(TermKind::kPair)) continue;
    open.emplace_back(store.car(pattern), store.car(value));
    open.emplace_back(store.cdr(pattern), store.cdr(value));
  }
}

}  // namespace

RepairSearches::RepairSearches(const Domain& domain, const Problem& present,
                               const RepairRequest& request, const RepairOptions& options,
                               const Host& host)
    : domain_(domain),
      store_(domain.store()),
      present_(present),
      request_(request),
      options_(options),
      host_(host) {
  if (host_.cpu_seconds) began_ = host_.cpu_seconds();
}

Repair RepairSearches::run(const std::vector<RepairAttempt>& attempts, bool applies) {
  applies_ = applies;
  prepare(attempts);
  std::uint64_t effort = kFirstEffort + kEffortPerNode * request_.plan->tree.size();
  while (!pending_.empty() && found_.empty()) {
    std::vector<Pending> cut;
    for (Pending& pending : pending_) {
      const End end = search(pending, effort);
      if (end == End::kStop || satisfied()) return finish();
      if (end == End::kEffort) cut.push_back(std::move(pending));
    }
    pending_ = std::move(cut);
    effort *= kMoreEffort;
  }
  return finish();
}

// Attempts that leave the same tasks are made once.
void RepairSearches::prepare(const std::vector<RepairAttempt>& attempts) {
  for (const RepairAttempt& attempt : attempts) {
    std::optional<RemainingTasks> remaining = attempt.tree->remaining(attempt.again);
    if (!remaining) {
      limit_ = "the tasks in progress are nested too deep";
      continue;
    }
    if (attempt.free_variables) free_variables(*attempt.tree, *remaining);
    number_variables(remaining->network);
    const auto same = [&](const Pending& pending) {
      return pending.remaining.leaves == remaining->leaves &&
             pending.remaining.network == remaining->network;
    };
    if (std::any_of(pending_.begin(), pending_.end(), same)) continue;
    std::vector<Preference> preferences = attempt.tree->preferences(remaining->leaves);
    pending_.push_back({&attempt, std::move(*remaining), std::move(preferences)});
  }
}

// Tasks of the problem get back the variables that only the old plan bound.
void RepairSearches::free_variables(const OldTree& tree, RemainingTasks& remaining) const {
  TaskNetwork given = present_.tasks;
  std::vector<TaskNetwork*> wanted;
  collect_leaves(given, wanted);
  const auto nothing = [this](const TaskNetwork* task) {
    return task->task.is(TermKind::kPair) && store_.car(task->task) == store_.symbol("!!inop");
  };
  std::erase_if(wanted, nothing);
  const std::vector<TreeIndex> tops = tree.top_tasks();
  if (tops.size() < wanted.size()) return;
  const std::size_t homeless = tops.size() - wanted.size();  // executed steps come first
  std::map<std::uint32_t, Term> bound;
  std::map<TreeIndex, Term> original;
  for (std::size_t at = 0; at < wanted.size(); ++at) {
    const TreeIndex top = tops[homeless + at];
    original[top] = wanted[at]->task;
    if (tree.done(top)) match(store_, wanted[at]->task, request_.plan->tree[top].task, bound);
  }
  std::vector<TaskNetwork*> leaves;
  collect_leaves(remaining.network, leaves);
  for (std::size_t at = 0; at < leaves.size(); ++at) {
    const auto known = original.find(remaining.leaves[at]);
    if (known == original.end()) continue;
    leaves[at]->task = map_leaves(store_, known->second, kHasLocal, [&](Term variable) {
      const auto value = bound.find(variable.index());
      return value == bound.end() ? variable : value->second;
    });
  }
}

// Variables as a problem has them: kLocal, numbered from 0.
void RepairSearches::number_variables(TaskNetwork& network) const {
  std::vector<TaskNetwork*> leaves;
  collect_leaves(network, leaves);
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (TaskNetwork* leaf : leaves) {
    leaf->task = map_leaves(store_, leaf->task, kHasLocal | kHasVariable, [&](Term variable) {
      const auto next = static_cast<std::uint32_t>(numbers.size());
      return Term(TermKind::kLocal, numbers.try_emplace(variable.bits(), next).first->second);
    });
  }
}

RepairSearches::End RepairSearches::search(const Pending& pending, std::uint64_t effort) {
  Problem problem = present_;
  problem.tasks = pending.remaining.network;
  Options options;
  options.trees = true;
  options.preferences = pending.preferences;
  options.limits = limits(effort);
  ++attempts_;
  Outcome outcome = plan(domain_, problem, options, host_);
  statistics_.expansions += outcome.statistics.expansions;
  statistics_.inferences += outcome.statistics.inferences;
  statistics_.deepest = std::max(statistics_.deepest, outcome.statistics.deepest);
  statistics_.memory_bytes = std::max(statistics_.memory_bytes, outcome.statistics.memory_bytes);
  if (!outcome.plans.empty()) {
    take(pending, std::move(outcome.plans.front()));
    return End::kDone;
  }
  if (outcome.verdict == Verdict::kError && error_.empty()) error_ = outcome.why;
  if (outcome.verdict != Verdict::kLimit) return End::kDone;
  const bool effort_spent = outcome.why == "expansions" || outcome.why == "inferences";
  if (effort_spent && !exhausted()) return End::kEffort;
  limit_ = outcome.why;
  return outcome.why == "depth" ? End::kDone : End::kStop;
}

Limits RepairSearches::limits(std::uint64_t effort) const {
  Limits out = options_.limits;
  const auto left = [](const std::optional<std::uint64_t>& limit, std::uint64_t used,
                       std::uint64_t wanted) {
    return limit ? std::min(wanted, *limit - std::min(*limit, used)) : wanted;
  };
  out.expansions = left(out.expansions, statistics_.expansions, effort);
  out.inferences = left(out.inferences, statistics_.inferences, effort * kInferencesPerExpansion);
  if (out.seconds && host_.cpu_seconds) {
    out.seconds = std::max(0.0, *out.seconds - (host_.cpu_seconds() - began_));
  }
  out.plans.reset();
  return out;
}

bool RepairSearches::exhausted() const {
  const Limits& all = options_.limits;
  return (all.expansions && statistics_.expansions >= *all.expansions) ||
         (all.inferences && statistics_.inferences >= *all.inferences);
}

void RepairSearches::take(const Pending& pending, Plan made) {
  const Plan& old = *request_.plan;
  const StepIndex executed = request_.executed;
  const RepairAttempt& attempt = *pending.attempt;
  Repair repair;
  repair.redone = redone_tasks(old, *attempt.tree, pending.remaining, made, attempt.again, store_);
  const bool in_other_order = applies_ && attempt.again.empty() && repair.redone.empty();
  if (in_other_order) return take_old();
  std::vector<TreeNode> tree = merged_tree(old, *attempt.tree, pending.remaining, made, executed);
  repair.plan = std::move(made);
  repair.plan.tree = std::move(tree);
  for (StepIndex step = 0; step < executed; ++step)
    repair.plan.steps[step].action = old.steps[step].action;
  compare_steps(old, executed, store_, repair);
  const auto same = [this](const Step& left, const Step& right) {
    return renumbered(left.action, store_) == renumbered(right.action, store_);
  };
  const bool stands =
      attempt.again.empty() && std::equal(old.steps.begin(), old.steps.end(),
                                          repair.plan.steps.begin(), repair.plan.steps.end(), same);
  repair.verdict = stands ? RepairVerdict::kStands : RepairVerdict::kRepaired;
  found_.push_back(std::move(repair));
}

// Every task came out as before, if in another order: the old order is as good.
void RepairSearches::take_old() {
  Repair repair;
  repair.plan = *request_.plan;
  compare_steps(repair.plan, request_.executed, store_, repair);
  repair.verdict = RepairVerdict::kStands;
  found_.push_back(std::move(repair));
}

bool RepairSearches::satisfied() const {
  if (found_.empty()) return false;
  return found_.back().verdict == RepairVerdict::kStands || found_.back().dropped.empty() ||
         found_.size() >= std::max<std::size_t>(1, options_.compared);
}

Repair RepairSearches::finish() {
  Repair repair;
  const auto best =
      std::min_element(found_.begin(), found_.end(), [](const Repair& left, const Repair& right) {
        if (left.kept.size() != right.kept.size()) return left.kept.size() > right.kept.size();
        return left.added.size() < right.added.size();
      });
  if (best != found_.end()) {
    repair = std::move(*best);
  } else if (!limit_.empty()) {
    repair.verdict = RepairVerdict::kLimit;
    repair.why = limit_;
  } else {
    repair.verdict = error_.empty() ? RepairVerdict::kNoPlan : RepairVerdict::kError;
    repair.why = error_;
  }
  repair.attempts = attempts_;
  repair.statistics = statistics_;
  return repair;
}

}  // namespace skein::htn
