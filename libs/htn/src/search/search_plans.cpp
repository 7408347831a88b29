// SPDX-License-Identifier: Apache-2.0
// What the search does with the plans it meets, with preferences and with its listeners.
#include <algorithm>
#include <map>

#include "search/search.hpp"
#include "skein/htn/term_map.hpp"

namespace skein::htn {

// A sequence of steps that leaves nothing to do.
Search::Move Search::found() {
  if (options_.following && followed_ != options_.following->steps) return Move::kBack;
  const bool again = options_.which == Which::kFirst && best_ && equal_value(*best_, cost_);
  const bool wanted = !again && acceptable(cost_) && keep(depth_);
  if (wanted) {
    plans.push_back(make_plan());
    if (host_.plan_found) host_.plan_found(plans.back());
  }
  return wanted && enough() ? Move::kStop : Move::kBack;
}

// Whether the plan is one of those asked for; those it supersedes go. Where cost counts one plan is
// kept whatever the mode: so does SHOP3, whose filter of dearer plans leaves none.
bool Search::keep(std::uint64_t depth) {
  const bool optimizing = options_.optimize_cost || options_.which == Which::kBest;
  if (optimizing || options_.cost_limit) {
    best_ = cost_;
    plans.clear();
  }
  switch (options_.which) {
    case Which::kShallowest:
      if (optimizing || options_.cost_limit) {
        cutoff_ = depth;
      } else {
        plans.clear();
        cutoff_ = depth == 0 ? 0 : depth - 1;
      }
      return true;
    case Which::kAllShallowest:
      if (cutoff_ != depth) plans.clear();
      cutoff_ = depth;
      return true;
    case Which::kIdAll:
      return !deepening_.known_depth || depth > *deepening_.known_depth;
    default:
      return true;
  }
}

bool Search::enough() const {
  if (options_.limits.plans && plans.size() >= *options_.limits.plans) return true;
  if (options_.which != Which::kFirst && options_.which != Which::kIdFirst) return false;
  if (options_.cost_limit) return less_value(*best_, real(*options_.cost_limit));
  if (options_.optimize_cost) return equal_value(*best_, integer(0));
  return true;
}

bool Search::acceptable(const Number& cost) const {
  if (options_.cost_limit) return to_double(cost) <= *options_.cost_limit;
  if (!best_) return true;
  if (options_.which == Which::kBest) return less_value(cost, *best_);
  return !options_.optimize_cost || !less_value(*best_, cost);
}

// Branch and bound: whether a partial plan of this cost may still become a wanted one.
bool Search::affordable(const Number& cost) {
  const bool prunes = options_.cost_limit || options_.optimize_cost ||
                      (options_.which == Which::kBest && !course_.negative_cost);
  const bool allowed = !prunes || acceptable(cost);
  course_.too_costly = course_.too_costly || !allowed;
  return allowed;
}

bool Search::follows(Term action) {
  if (!options_.following) return true;
  static constexpr std::string_view kNothing = "!!inop";
  if (store_.name(store_.car(action)) == kNothing) return true;
  const Following& given = *options_.following;
  return followed_ < given.steps && given.agrees(followed_++, action);
}

Plan Search::make_plan() {
  Plan plan;
  const Term nothing = store_.pair(store_.symbol("!!inop"), kNil);
  std::vector<StepIndex> renumbered(steps_.size(), kNoStep);
  for (std::size_t at = 0; at < steps_.size(); ++at) {
    if (steps_[at].action == nothing) continue;
    renumbered[at] = static_cast<StepIndex>(plan.steps.size());
    const Term name = store_.car(steps_[at].action);
    plan.steps.push_back({steps_[at].action, steps_[at].cost, internal(store_, name)});
  }
  for (std::size_t at = 0; options_.states && at < steps_.size(); ++at) {
    if (renumbered[at] != kNoStep) plan.changes.push_back(steps_[at].change);
  }
  plan.cost = cost_;
  if (options_.trees) plan.tree = make_tree(renumbered);
  return plan;
}

// The nodes of the agenda are the tree; empty reductions lose their step that does nothing.
std::vector<TreeNode> Search::make_tree(const std::vector<StepIndex>& renumbered) {
  const auto links = [&](const std::vector<CausalLink>& support) {
    std::vector<CausalLink> out;
    for (CausalLink link : support) {
      if (link.step < renumbered.size()) link.step = renumbered[link.step];
      if (std::find(out.begin(), out.end(), link) == out.end()) out.push_back(link);
    }
    return out;
  };
  std::vector<TreeIndex> place(agenda_.size(), kNoParent);
  std::vector<TreeNode> tree;
  for (NodeId id = 0; id < agenda_.size(); ++id) {
    const AgendaNode& node = agenda_[id];
    const bool task = node.kind == NetworkKind::kTask;
    const bool step = task && node.first_child == kNoNodeId;
    if (step && renumbered[node.note] == kNoStep) continue;
    TreeNode& made = tree.emplace_back();
    place[id] = static_cast<TreeIndex>(tree.size() - 1);
    made.kind = step                                   ? TreeNodeKind::kStep
                : task                                 ? TreeNodeKind::kTask
                : node.kind == NetworkKind::kUnordered ? TreeNodeKind::kUnordered
                                                       : TreeNodeKind::kOrdered;
    made.immediate = node.immediate;
    if (step) {
      made.step = renumbered[node.note];
      made.task = steps_[node.note].action;
      made.support = links(steps_[node.note].support);
    } else if (task) {
      made.task = bindings_.instance(node.task, 0);
      made.method = notes_[node.note].branch->label;
      made.support = links(notes_[node.note].support);
    }
    if (node.parent == kNoNodeId) continue;
    made.parent = place[node.parent];
    tree[made.parent].children.push_back(place[id]);
  }
  return tree;
}

bool Search::traced(Term task) const {
  if (traced_.empty()) return true;
  return traced_.contains(task.is(TermKind::kPair) ? store_.car(task) : task);
}

void Search::tell(TraceKind kind, Term task, std::string label, std::uint64_t count,
                  std::string detail) {
  host_.trace({kind, depth_, task, std::move(label), count, std::move(detail)});
}

// A label that the reader made is no name: where the branch stands says more.
Reducer::Tell Search::teller(Term task, std::uint32_t method, bool only) {
  return [this, task, method, only](const Method& of, const Branch& branch, Base base,
                                    const Answers& answers) {
    const std::size_t number = static_cast<std::size_t>(&branch - of.branches.data()) + 1;
    const std::string name(store_.name(store_.car(of.head)));
    std::string label = branch.label;
    if (label == name + '-' + std::to_string(number)) {
      label = (only ? "" : "method " + std::to_string(method) + ", ") + "branch " +
              std::to_string(number);
    }
    const bool holds = answers.count() > 0;
    tell(holds ? TraceKind::kBranchHolds : TraceKind::kBranchFails, task, std::move(label),
         answers.count(),
         holds ? explainer().values_text(of, base, answers)
               : explainer().unmet_text(branch.precondition, {of, base}));
  };
}

// Reductions that an earlier plan used for this task come first.
void Search::prefer(Term task, std::size_t first) {
  const Preference* preference = preferences_.find(task);
  if (preference == nullptr) return;
  const auto liked = [&](const Reduction& reduction) {
    return preference->method == reduction.branch->label &&
           preferences_.agrees(
               *preference,
               std::span(pool_.tasks).subspan(reduction.tasks, reduction.branch->leaves.size()));
  };
  std::stable_partition(pool_.reductions.begin() + static_cast<std::ptrdiff_t>(first),
                        pool_.reductions.end(), liked);
}

std::uint32_t Search::preferred_method(Term task, const std::vector<Method>& methods) const {
  const Preference* preference = preferences_.find(task);
  if (preference == nullptr) return kAbsent;
  for (std::uint32_t at = 0; at < methods.size(); ++at) {
    for (const Branch& branch : methods[at].branches) {
      if (branch.label == preference->method) return at;
    }
  }
  return kAbsent;
}

// Of the tasks on the agenda the one that came first in the earlier plan.
NodeId Search::preferred_node() {
  NodeId best = agenda_.first();
  std::uint32_t least = kAbsent;
  for (NodeId at = best; at != kNoNodeId; at = agenda_.next_distinct(at)) {
    const Preference* preference = preferences_.find(bindings_.instance(agenda_[at].task, 0));
    if (preference == nullptr || preference->order >= least) continue;
    least = preference->order;
    best = at;
  }
  return best;
}

NodeId Search::behind(NodeId node, NodeId tried) const {
  const NodeId next = agenda_.next_distinct(node);
  return next == tried && tried != kNoNodeId ? agenda_.next_distinct(next) : next;
}

// One event; false for a step that does not apply as it is given.
bool Search::relive(const Event& event) {
  if (event.kind == Event::Kind::kAdded) {
    facts_.add(event.term, kOutside);
    return true;
  }
  if (event.kind == Event::Kind::kDeleted) {
    facts_.remove(event.term, kOutside);
    return true;
  }
  std::map<Term, Term, bool (*)(Term, Term)> cells(
      [](Term left, Term right) { return left.bits() < right.bits(); });
  const Term action = map_leaves(store_, event.term, kHasLocal | kHasVariable, [&](Term variable) {
    const auto [at, fresh] = cells.try_emplace(variable, kNil);
    if (fresh) at->second = Term(TermKind::kVariable, bindings_.open(1));
    return at->second;
  });
  const auto operation =
      domain_.operators.find(action.is(TermKind::kPair) ? store_.car(action) : action);
  MadeStep made;
  const bool applied =
      operation != domain_.operators.end() &&
      steps_made_->apply(operation->second, action, static_cast<StepIndex>(steps_.size()), made);
  if (!applied) return false;
  const Result<Number, Failure> cost = add(cost_, made.cost);
  if (!cost) return false;
  cost_ = *cost;
  steps_.push_back({made.action, made.cost, std::move(made.support), std::move(made.change)});
  return true;
}

// No step can be blamed for what the world made false.
void Search::drop_broken_protections() {
  std::vector<Term> broken;
  protections_.for_each([&](Term atom) {
    if (!prover_->holds(atom)) broken.push_back(atom);
  });
  for (const Term atom : broken) {
    while (protections_.count(atom) > 0) protections_.release(atom);
  }
}

}  // namespace skein::htn
