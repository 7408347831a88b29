// SPDX-License-Identifier: Apache-2.0
// Plans of drawn domains judged by playing their steps on bits: states, causal links, trees.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "skein/htn/planner.hpp"
#include "testing/naive_planner.hpp"

namespace skein::htn::test {

/// Says what is wrong with a plan that was asked for with trees and states; nothing when all is
/// well. It knows the domain by its bits only.
class PlanChecker {
 public:
  PlanChecker(const NaiveDomain& domain, unsigned facts, const TermStore& store)
      : domain_(domain), store_(store), before_{facts} {}

  std::string fault(const Plan& plan) {
    plan_ = &plan;
    for (StepIndex step = 0; step < plan.steps.size(); ++step) {
      if (const std::string wrong = play(step); !wrong.empty()) return at(step, wrong);
    }
    std::vector<int> met(plan.steps.size());
    for (TreeIndex node = 0; node < plan.tree.size(); ++node) {
      const TreeNode& here = plan.tree[node];
      if (const std::string wrong = check(node); !wrong.empty())
        return "node " + std::to_string(node) + ": " + wrong;
      if (here.kind == TreeNodeKind::kStep) ++met[here.step];
    }
    const bool once = std::all_of(met.begin(), met.end(), [](int times) { return times == 1; });
    return once ? "" : "a step that stands not once in the tree";
  }
  /// Facts after so many steps of the plan that was judged last.
  unsigned after(std::size_t steps) const { return before_.at(steps); }

 private:
  struct Span {
    StepIndex first = kNoStep;
    StepIndex last = 0;
    bool empty() const { return first == kNoStep; }
  };

  static std::string at(StepIndex step, const std::string& wrong) {
    return "step " + std::to_string(step) + ": " + wrong;
  }
  int number_of(Term action) const { return store_.to_text(store_.car(action)).back() - '0'; }
  /// The bit of "(f2)", or of what "(not (f2))" denies.
  unsigned bit(Term fact) const {
    const std::string text = store_.to_text(fact);
    return 1U << (text[text.find('f') + 1] - '0');
  }
  bool denied(Term fact) const { return store_.to_text(fact).starts_with("(not"); }
  unsigned bits(const std::vector<Term>& facts) const {
    unsigned all = 0;
    for (const Term fact : facts) all |= bit(fact);
    return all;
  }

  /// The step on the state so far, and what the plan says of it.
  std::string play(StepIndex step) {
    const auto& taken =
        domain_.operators.at(static_cast<std::size_t>(number_of(plan_->steps[step].action)));
    before_.resize(step + 1U);
    const unsigned old = before_.back();
    const unsigned made = (old & ~taken.removes) | taken.adds;
    if ((old & taken.needs) != taken.needs) return "its precondition does not hold";
    if (bits(plan_->changes.at(step).deleted) != (old & ~made)) return "other facts deleted";
    if (bits(plan_->changes.at(step).added) != (made & ~old)) return "other facts added";
    before_.push_back(made);
    return "";
  }

  /// Whether what is linked was as it was needed from its producer up to before `until`.
  std::string link_fault(const CausalLink& link, StepIndex until) const {
    const unsigned fact = bit(link.fact);
    const bool wanted = !denied(link.fact);
    const auto is_so = [&](std::size_t state) { return ((before_[state] & fact) != 0) == wanted; };
    if (link.step != kInitialState && link.step >= until) return "a link to a later step";
    const std::size_t from = link.step == kInitialState ? 0 : link.step + 1U;
    if (from > 0 && !establishes(plan_->steps[link.step], fact, wanted))
      return "a link to a step that does not establish it";
    for (std::size_t state = from; state <= until; ++state)
      if (!is_so(state)) return "a link that was broken before its end";
    return "";
  }

  bool establishes(const Step& step, unsigned fact, bool wanted) const {
    const auto& taken = domain_.operators[static_cast<std::size_t>(number_of(step.action))];
    return ((wanted ? taken.adds : taken.removes & ~taken.adds) & fact) != 0;
  }

  std::string check(TreeIndex index) const {
    const TreeNode& node = plan_->tree[index];
    for (const TreeIndex child : node.children)
      if (plan_->tree[child].parent != index) return "a child of another parent";
    if (node.kind == TreeNodeKind::kStep) return check_step(node);
    if (node.kind == TreeNodeKind::kOrdered) return check_order(node);
    if (node.kind == TreeNodeKind::kTask) return check_reduction(index);
    return "";
  }

  std::string check_step(const TreeNode& node) const {
    unsigned supported = 0;
    for (const CausalLink& link : node.support) {
      supported |= denied(link.fact) ? 0 : bit(link.fact);
      if (const std::string wrong = link_fault(link, node.step); !wrong.empty()) return wrong;
    }
    const auto& taken = domain_.operators[static_cast<std::size_t>(number_of(node.task))];
    return supported == taken.needs ? "" : "links to other facts than it needs";
  }

  std::string check_order(const TreeNode& node) const {
    Span so_far;
    for (const TreeIndex child : node.children) {
      const Span next = span(child);
      if (next.empty()) continue;
      if (!so_far.empty() && next.first <= so_far.last) return "ordered parts that overlap";
      so_far = next;
    }
    return "";
  }

  /// A way of the task that has these parts, that its facts allow.
  std::string check_reduction(TreeIndex index) const {
    const TreeNode& node = plan_->tree[index];
    if (node.children.size() > 1) return "a task of several networks";
    std::vector<int> parts;
    bool ordered = true;
    if (!node.children.empty()) {
      const TreeNode& network = plan_->tree[node.children.front()];
      ordered = network.kind == TreeNodeKind::kOrdered;
      for (const TreeIndex child : network.children) parts.push_back(part(plan_->tree[child]));
    }
    unsigned supported = 0;
    for (const CausalLink& link : node.support)
      if (!denied(link.fact)) supported |= bit(link.fact);
    const int task = store_.to_text(node.task).at(2) - '0';
    const bool known =
        std::any_of(domain_.ways.begin(), domain_.ways.end(), [&](const NaiveDomain::Way& way) {
          return way.of == task && way.parts == parts && way.needs == supported &&
                 (way.ordered == ordered || parts.size() < 2);
        });
    return known ? "" : "a reduction that no method gives";
  }
  int part(const TreeNode& node) const {
    const std::string text = store_.to_text(node.task);
    return node.kind == TreeNodeKind::kStep ? -1 - number_of(node.task) : text.at(2) - '0';
  }

  Span span(TreeIndex index) const {
    const TreeNode& node = plan_->tree[index];
    if (node.kind == TreeNodeKind::kStep) return {node.step, node.step};
    Span all;
    for (const TreeIndex child : node.children) {
      const Span one = span(child);
      if (one.empty()) continue;
      all.first = all.empty() ? one.first : std::min(all.first, one.first);
      all.last = std::max(all.last, one.last);
    }
    return all;
  }

  const NaiveDomain& domain_;
  const TermStore& store_;
  const Plan* plan_ = nullptr;
  std::vector<unsigned> before_;  ///< facts before each step, and behind the last
};

}  // namespace skein::htn::test
