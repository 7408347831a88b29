// SPDX-License-Identifier: Apache-2.0
#include "replay/tree.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace skein::htn::replay {

namespace {

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

/// When a node may have been reduced, and which steps lie below it.
struct Span {
  std::size_t earliest = 0;
  std::size_t first = kNever;
  std::size_t last = 0;  ///< of the steps below, if first is not kNever
};

class TreeCheck {
 public:
  TreeCheck(ProofContext& context, const GivenPlan& plan, const std::vector<Application>& done)
      : context_(context),
        plan_(plan),
        done_(done),
        spans_(plan.tree.size()),
        idle_(plan.tree.size()) {}

  std::optional<TreeFault> run(World& world, const NetworkClause& tasks, std::uint32_t slots) {
    if (auto fault = order_nodes()) return fault;
    if (auto fault = measure()) return fault;
    free_tasks();
    const Bindings::Mark mark = context_.bindings.mark();
    const std::uint32_t base = context_.bindings.fresh(slots);
    const bool same = matches(tasks, base, 0);
    context_.bindings.undo(mark);
    if (!same) return TreeFault{0, "the root is not the problem's task network"};
    return check_reductions(world);
  }

 private:
  const GivenNode& node(TreeIndex index) const { return plan_.tree[index]; }

  // What the planner left unbound is a variable here too, the same one all over the tree.
  void free_tasks() {
    std::map<std::uint32_t, Term> fresh;
    for (const GivenNode& here : plan_.tree) {
      tasks_.push_back(replace_variables(context_.store, here.task, [&](Term variable) {
        const auto [at, is_new] = fresh.try_emplace(variable.index());
        if (is_new) at->second = Term(TermKind::kVariable, context_.bindings.fresh(1));
        return at->second;
      }));
    }
  }

  // Parents before children; every node but the root has one parent.
  std::optional<TreeFault> order_nodes() {
    std::vector<bool> seen(plan_.tree.size(), false);
    top_down_ = {0};
    for (std::size_t at = 0; at < top_down_.size(); ++at) {
      for (const TreeIndex child : node(top_down_[at]).children) {
        if (child == 0 || child >= seen.size() || seen[child]) {
          return TreeFault{top_down_[at], "its children are not a tree"};
        }
        seen[child] = true;
        top_down_.push_back(child);
      }
    }
    if (top_down_.size() != plan_.tree.size()) return TreeFault{0, "some nodes have no parent"};
    return {};
  }

  std::optional<TreeFault> measure() {
    std::vector<bool> used(plan_.steps.size(), false);
    for (auto at = top_down_.rbegin(); at != top_down_.rend(); ++at) {
      Span& span = spans_[*at];
      const GivenNode& here = node(*at);
      idle_[*at] = does_nothing(here);
      if (here.kind == TreeNodeKind::kStep && here.step != kNoStep) {
        if (here.step >= used.size() || used[here.step]) {
          return TreeFault{*at, "its step is not in the plan, or in the tree twice"};
        }
        used[here.step] = true;
        span.first = span.last = here.step;
      }
      for (const TreeIndex child : here.children) {
        if (spans_[child].first == kNever) continue;
        if (here.kind == TreeNodeKind::kOrdered && span.first != kNever &&
            spans_[child].first < span.last) {
          return TreeFault{*at, "its steps are not in the order its network demands"};
        }
        span.last =
            span.first == kNever ? spans_[child].last : std::max(span.last, spans_[child].last);
        span.first = std::min(span.first, spans_[child].first);
      }
    }
    const auto lost = std::find(used.begin(), used.end(), false);
    if (lost != used.end()) {
      return TreeFault{0,
                       "step " + std::to_string(lost - used.begin() + 1) + " is not in the tree"};
    }
    for (const TreeIndex at : top_down_) spread_earliest(at);
    return {};
  }

  bool does_nothing(const GivenNode& here) const {
    if (here.kind == TreeNodeKind::kTask) return false;
    if (here.kind == TreeNodeKind::kStep) return here.step == kNoStep;
    return std::all_of(here.children.begin(), here.children.end(),
                       [&](TreeIndex child) { return idle_[child]; });
  }

  void spread_earliest(TreeIndex at) {
    std::size_t earliest = spans_[at].earliest;
    for (const TreeIndex child : node(at).children) {
      spans_[child].earliest = earliest;
      if (node(at).kind == TreeNodeKind::kOrdered && spans_[child].first != kNever) {
        earliest = spans_[child].last + 1;
      }
    }
  }

  bool idle(const NetworkClause& clause) const {
    if (clause.kind == TreeNodeKind::kTask) {
      return predicate_of(context_.store, clause.pattern) == context_.store.symbol(kNoOperation);
    }
    return std::all_of(clause.children.begin(), clause.children.end(),
                       [&](const NetworkClause& child) { return idle(child); });
  }

  // Networks of one child count as that child, and what does nothing does not count.
  bool matches(const NetworkClause& clause, std::uint32_t base, TreeIndex at) {
    std::vector<const NetworkClause*> wanted;
    const NetworkClause* outer = &clause;
    while (outer->kind != TreeNodeKind::kTask) {
      wanted.clear();
      for (const NetworkClause& child : outer->children) {
        if (!idle(child)) wanted.push_back(&child);
      }
      if (wanted.size() != 1) break;
      outer = wanted[0];
    }
    std::vector<TreeIndex> given;
    while (node(at).kind == TreeNodeKind::kOrdered || node(at).kind == TreeNodeKind::kUnordered) {
      given.clear();
      for (const TreeIndex child : node(at).children) {
        if (!idle_[child]) given.push_back(child);
      }
      if (given.size() != 1) break;
      at = given[0];
    }
    const bool leaf = node(at).kind == TreeNodeKind::kTask || node(at).kind == TreeNodeKind::kStep;
    if (outer->kind == TreeNodeKind::kTask) {
      if (idle(*outer)) return idle_[at];
      return leaf && context_.bindings.unify(task_of(*outer, base), tasks_[at]);
    }
    if (leaf) return wanted.empty() && idle_[at];
    if (wanted.size() != given.size()) return false;
    if (!wanted.empty() && outer->kind != node(at).kind) return false;
    for (std::size_t child = 0; child < wanted.size(); ++child) {
      if (!matches(*wanted[child], base, given[child])) return false;
    }
    return true;
  }

  Term task_of(const NetworkClause& clause, std::uint32_t base) {
    if (clause.items.empty()) return context_.bindings.instance(clause.pattern, base);
    std::vector<Term> items;
    for (const NetworkClause::Item& item : clause.items) {
      items.push_back(item.code == kNoCode ? context_.bindings.instance(item.pattern, base)
                                           : evaluate(context_, item.code, base));
    }
    return context_.store.list(items);
  }

  static bool calls(const NetworkClause& clause) {
    return !clause.items.empty() ||
           std::any_of(clause.children.begin(), clause.children.end(), calls);
  }

  bool reduced_by(const MethodClause& method, std::size_t branch, TreeIndex at) {
    const Bindings::Mark mark = context_.bindings.mark();
    const std::uint32_t base = context_.bindings.fresh(method.slots);
    bool found = context_.bindings.unify(context_.bindings.instance(method.head, base), tasks_[at]);
    for (std::size_t earlier = 0; found && earlier < branch; ++earlier) {
      found = !provable(context_, method.branches[earlier].precondition.goals, base);
    }
    const BranchClause& chosen = method.branches[branch];
    const bool late = calls(chosen.tasks);
    if (found && !late) found = children_match(chosen.tasks, base, at);
    if (found) {
      found = false;
      Proof proof(context_, chosen.precondition.goals, base);
      while (!found && proof.next()) {
        found = !late || children_match(chosen.tasks, base, at);
      }
    }
    context_.bindings.undo(mark);
    return found;
  }

  bool children_match(const NetworkClause& tasks, std::uint32_t base, TreeIndex at) {
    const std::vector<TreeIndex>& below = node(at).children;
    return below.empty() ? idle(tasks) : below.size() == 1 && matches(tasks, base, below[0]);
  }

  bool reduced(TreeIndex at) {
    const Term name = predicate_of(context_.store, node(at).task);
    for (const MethodClause& method : context_.clauses.methods_for(name)) {
      for (std::size_t branch = 0; branch < method.branches.size(); ++branch) {
        if (method.branches[branch].label == node(at).method && reduced_by(method, branch, at)) {
          return true;
        }
      }
    }
    return false;
  }

  // First in the state before the first step below; what fails there, in all states it may be.
  std::optional<TreeFault> check_reductions(World& world) {
    std::vector<TreeIndex> open;
    for (const TreeIndex at : top_down_) {
      if (node(at).kind == TreeNodeKind::kTask) open.push_back(at);
      if (node(at).kind == TreeNodeKind::kStep && node(at).step != kNoStep &&
          !alike(context_.store, node(at).task, plan_.steps[node(at).step].action)) {
        return TreeFault{at, "its task is not the step it names"};
      }
    }
    for (const bool everywhere : {false, true}) {
      open = still_open(world, std::move(open), everywhere);
      if (context_.error) return TreeFault{0, *context_.error};
      if (open.empty()) return {};
    }
    return TreeFault{open.front(), "task " + context_.store.to_text(node(open.front()).task) +
                                       ": method " + node(open.front()).method +
                                       " did not apply with these subtasks"};
  }

  std::vector<TreeIndex> still_open(World& world, std::vector<TreeIndex> open, bool everywhere) {
    const std::size_t mark = world.mark();
    for (std::size_t time = 0; time <= done_.size() && !open.empty(); ++time) {
      std::erase_if(open, [&](TreeIndex at) {
        const Span& span = spans_[at];
        const std::size_t latest = std::min(span.first, done_.size());
        const std::size_t usual = span.first == kNever ? span.earliest : span.first;
        const bool now = everywhere ? span.earliest <= time && time <= latest : time == usual;
        return now && reduced(at);
      });
      if (time < done_.size()) apply(context_, world, done_[time]);
    }
    world.undo(mark);
    return open;
  }

  ProofContext& context_;
  const GivenPlan& plan_;
  const std::vector<Application>& done_;
  std::vector<Span> spans_;
  std::vector<Term> tasks_;
  std::vector<bool> idle_;  ///< no task and no step of the plan below
  std::vector<TreeIndex> top_down_;
};

}  // namespace

std::optional<TreeFault> check_tree(ProofContext& context, World& world, const NetworkClause& tasks,
                                    std::uint32_t task_slots, const GivenPlan& plan,
                                    const std::vector<Application>& done) {
  return TreeCheck(context, plan, done).run(world, tasks, task_slots);
}

}  // namespace skein::htn::replay
