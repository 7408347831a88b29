// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/plan_text.hpp"

#include <algorithm>
#include <vector>

#include "shown/shown_tree.hpp"
#include "skein/htn/utf8.hpp"

namespace skein::htn {

namespace {

constexpr std::size_t kWidestAligned = 60;  // costs of longer steps stand where these end
constexpr std::size_t kDeepestGuides = 40;

std::size_t digits_of(std::size_t count) { return std::to_string(count).size(); }

std::string right_aligned(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

/// Writes the tree node by node, with the guides of the levels above it.
class TreePrinter {
 public:
  TreePrinter(const Plan& plan, const TermStore& store, const PlanTextOptions& options)
      : plan_(plan), store_(store), style_(options.style), tree_(plan, options.internal) {}

  std::string print() {
    open(tree_.top(), 0);
    while (!pending_.empty()) {
      const Pending next = pending_.back();
      pending_.pop_back();
      ends_.resize(next.depth);
      const std::vector<TreeIndex> below = tree_.below(next.node);
      line(next, !below.empty());
      ends_.push_back(next.last);
      open(below, next.depth + 1);
    }
    return std::move(out_);
  }

 private:
  struct Pending {
    TreeIndex node = 0;
    std::size_t depth = 0;
    bool last = false;
  };

  void open(const std::vector<TreeIndex>& nodes, std::size_t depth) {
    for (auto at = nodes.rbegin(); at != nodes.rend(); ++at) {
      pending_.push_back({*at, depth, at == nodes.rbegin()});
    }
  }

  // Top-level nodes have no guide, so those of level 1 begin the line.
  std::string guides() const {
    const std::size_t left_out =
        ends_.size() > kDeepestGuides ? ends_.size() - kDeepestGuides : std::size_t{1};
    std::string out;
    if (left_out > 1) out = "[+" + std::to_string(left_out - 1) + "] ";
    for (std::size_t level = left_out; level < ends_.size(); ++level) {
      out += ends_[level] ? "   " : "│  ";
    }
    return out;
  }

  void line(const Pending& pending, bool has_children) {
    const TreeNode& node = tree_[pending.node];
    const std::string above = guides();
    std::string branch;
    if (pending.depth > 0) branch = pending.last ? "└─ " : "├─ ";
    out_ += style_.mark(style_.dim, above + branch);
    out_ += text_of(node) + '\n';
    std::string below = above;
    if (pending.depth > 0) below += pending.last ? "   " : "│  ";
    below += has_children ? "│  " : "   ";
    for (const CausalLink& link : tree_.made(pending.node)) {
      out_ += style_.mark(style_.dim, below + text_of(link)) + '\n';
    }
  }

  std::string text_of(const TreeNode& node) const {
    if (node.kind == TreeNodeKind::kStep) {
      const Step& step = plan_.steps[node.step];
      return style_.mark(style_.bold, std::to_string(tree_.numbers()[node.step] + 1)) + ' ' +
             style_.mark(style_.good, store_.to_text(node.task)) + "  " +
             style_.mark(style_.dim, "cost " + to_text(step.cost));
    }
    if (node.kind != TreeNodeKind::kTask) {
      return style_.mark(style_.dim,
                         node.kind == TreeNodeKind::kOrdered ? ":ordered" : ":unordered");
    }
    const std::string task = store_.to_text(node.task);
    return node.method.empty() ? task : task + "  " + style_.mark(style_.dim, node.method);
  }

  std::string text_of(const CausalLink& link) const {
    const StepIndex number = tree_.numbers()[link.step];
    if (link.step == kOutside) return "← " + store_.to_text(link.fact) + " from outside";
    return "← " + store_.to_text(link.fact) + " from " +
           (number == kNoStep ? std::string() : std::to_string(number + 1) + ' ') +
           tree_.operator_of(link.step, store_);
  }

  const Plan& plan_;
  const TermStore& store_;
  const TextStyle& style_;
  ShownTree tree_;
  std::vector<Pending> pending_;
  std::vector<bool> ends_;  // for each level above: was the node the last of its siblings?
  std::string out_;
};

// What a step made false, and what it made true.
void append_change(const std::vector<StateChange>& changes, StepIndex step, const TermStore& store,
                   std::size_t indent, std::string& out) {
  if (step >= changes.size()) return;
  for (const Term fact : changes[step].deleted) {
    out += std::string(indent, ' ') + "- " + store.to_text(fact) + '\n';
  }
  for (const Term fact : changes[step].added) {
    out += std::string(indent, ' ') + "+ " + store.to_text(fact) + '\n';
  }
}

}  // namespace

std::string steps_text(const Plan& plan, const TermStore& store, const PlanTextOptions& options) {
  const StepNumbers numbers(plan, options.internal);
  std::vector<StepIndex> places;
  std::vector<std::string> actions;
  std::vector<std::string> costs;
  std::size_t action_width = 0;
  std::size_t cost_width = 0;
  for (StepIndex at = 0; at < plan.steps.size(); ++at) {
    if (numbers[at] == kNoStep) continue;
    places.push_back(at);
    actions.push_back(store.to_text(plan.steps[at].action));
    costs.push_back(to_text(plan.steps[at].cost));
    action_width = std::max(action_width, count_characters(actions.back()));
    cost_width = std::max(cost_width, costs.back().size());
  }
  action_width = std::min(action_width, kWidestAligned);
  const std::size_t number_width = digits_of(numbers.count());
  std::string out;
  for (std::size_t at = 0; at < actions.size(); ++at) {
    const std::size_t width = count_characters(actions[at]);
    const std::string number = right_aligned(std::to_string(at + 1), number_width);
    out += "  " + options.style.mark(options.style.dim, number) + "  " + actions[at];
    if (width < action_width) out.append(action_width - width, ' ');
    out += "  " + options.style.mark(options.style.dim, right_aligned(costs[at], cost_width));
    out += '\n';
    if (options.states) append_change(plan.changes, places[at], store, number_width + 4, out);
  }
  return out;
}

std::string tree_text(const Plan& plan, const TermStore& store, const PlanTextOptions& options) {
  return TreePrinter(plan, store, options).print();
}

}  // namespace skein::htn
