// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/plan_graph.hpp"

#include <map>
#include <vector>

#include "shown/shown_tree.hpp"
#include "skein/htn/utf8.hpp"

namespace skein::htn {

namespace {

constexpr std::size_t kLongestLabel = 48;  // [characters]; the whole text is the tooltip

constexpr const char* kHead =
    "digraph plan {\n"
    "  rankdir=LR; nodesep=0.14; ranksep=0.5; splines=true; bgcolor=white;\n"
    "  fontname=\"Helvetica\"; labelloc=t; fontsize=16;\n"
    "  node [fontname=\"Helvetica\", fontsize=11, shape=box, style=\"rounded,filled\", "
    "fillcolor=white, color=\"#5b6770\", margin=\"0.12,0.06\", height=0.3];\n"
    "  edge [fontname=\"Helvetica\", fontsize=9, color=\"#5b6770\", arrowsize=0.6];\n";
constexpr const char* kStepStyle = "style=filled, fillcolor=\"#d8ecdc\", color=\"#2f7d46\"";
constexpr const char* kInternalStyle =
    "style=\"filled,dashed\", fillcolor=\"#f2f2ee\", color=\"#8a8a80\"";
constexpr const char* kNetworkStyle =
    "shape=plaintext, style=\"\", fontcolor=\"#5b6770\", margin=\"0.04,0.02\"";
// Facts stand in a column at the right of the steps, out of the way of the tree; what a task needed
// is told by a pale line and its tooltip alone.
constexpr const char* kFactStyle =
    "shape=plaintext, style=\"\", fontsize=10, fontcolor=\"#c05a1c\", margin=\"0.05,0.01\"";
constexpr const char* kFactLink = "style=dashed, color=\"#c05a1c\"";
constexpr const char* kTaskLink =
    "style=dashed, color=\"#e8b48f\", constraint=false, arrowsize=0.5, penwidth=0.8";

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') out += '\\';
    if (letter == '\n') {
      out += "\\n";
    } else {
      out += letter;
    }
  }
  return out + '"';
}

std::string shortened(const std::string& text) {
  if (count_characters(text) <= kLongestLabel) return text;
  std::size_t end = 0;
  for (std::size_t seen = 0; end < text.size(); ++end) {
    if (!continues_character(text[end]) && ++seen == kLongestLabel) break;
  }
  return text.substr(0, end) + "…";
}

class GraphWriter {
 public:
  GraphWriter(const Plan& plan, const TermStore& store, const PlanGraphOptions& options)
      : plan_(plan), store_(store), tree_(plan, options.internal), title_(options.title) {}

  std::string write() {
    out_ = kHead;
    if (!title_.empty()) out_ += "  label=" + quoted(title_) + ";\n";
    if (plan_.tree.empty()) {
      plain_steps();
    } else {
      nodes();
    }
    step_order();
    links();
    return out_ + "}\n";
  }

 private:
  void plain_steps() {
    for (StepIndex at = 0; at < plan_.steps.size(); ++at) {
      if (tree_.numbers()[at] != kNoStep) step(at);
    }
  }

  void nodes() {
    std::vector<TreeIndex> open = tree_.top();
    while (!open.empty()) {
      const TreeIndex at = open.back();
      open.pop_back();
      node(at);
      for (const TreeIndex child : tree_.below(at)) {
        out_ += "  " + name_of(at) + " -> " + name_of(child) + ";\n";
        open.push_back(child);
      }
      for (const CausalLink& link : tree_.made(at)) {
        if (tree_.numbers()[link.step] != kNoStep) note(link, at);
      }
    }
  }

  void note(const CausalLink& link, TreeIndex user) {
    if (tree_[user].kind == TreeNodeKind::kStep) {
      users_[{link.step, store_.to_text(link.fact)}].push_back(user);
    } else {
      std::string& facts = task_links_[{link.step, user}];
      facts += (facts.empty() ? "" : "\n") + store_.to_text(link.fact);
    }
  }

  void node(TreeIndex at) {
    const TreeNode& node = tree_[at];
    if (node.kind == TreeNodeKind::kStep) return step(node.step);
    if (node.kind != TreeNodeKind::kTask) {
      const char* word = node.kind == TreeNodeKind::kOrdered ? "ordered" : "unordered";
      out_ += "  " + name_of(at) + " [label=" + quoted(word) + ", " + kNetworkStyle + "];\n";
      return;
    }
    const std::string task = store_.to_text(node.task);
    std::string label = shortened(task);
    if (!node.method.empty()) label += '\n' + shortened(node.method);
    out_ += "  " + name_of(at) + " [label=" + quoted(label) + ", tooltip=" + quoted(task) + "];\n";
  }

  void step(StepIndex at) {
    const Step& step = plan_.steps[at];
    const std::string action = store_.to_text(step.action);
    const std::string label = std::to_string(tree_.numbers()[at] + 1) + "  " + shortened(action);
    out_ += "  " + step_name(at) + " [label=" + quoted(label) +
            ", tooltip=" + quoted(action + "  cost " + to_text(step.cost)) + ", " +
            (step.internal ? kInternalStyle : kStepStyle) + "];\n";
  }

  // Steps stand in one column, in the order of execution.
  void step_order() {
    if (tree_.numbers().count() < 2) return;
    out_ += "  { rank=same; edge [style=invis, weight=10];";
    bool first = true;
    for (StepIndex at = 0; at < plan_.steps.size(); ++at) {
      if (tree_.numbers()[at] == kNoStep) continue;
      out_ += (first ? " " : " -> ") + step_name(at);
      first = false;
    }
    out_ += "; }\n";
  }

  // Facts of one step with the same users are one node.
  void links() {
    std::map<std::pair<StepIndex, std::vector<TreeIndex>>, std::string> labels;
    for (const auto& [made, users] : users_) {
      std::string& label = labels[{made.first, users}];
      label += (label.empty() ? "" : "\n") + shortened(made.second);
    }
    std::size_t number = 0;
    for (const auto& [made, label] : labels) {
      const std::string fact = 'f' + std::to_string(number++);
      out_ += "  " + fact + " [label=" + quoted(label) + ", " + kFactStyle + "];\n";
      out_ += "  " + step_name(made.first) + ":e -> " + fact + ":w [" + kFactLink +
              ", arrowhead=none];\n";
      for (const TreeIndex user : made.second) {
        out_ += "  " + name_of(user) + ":e -> " + fact + ":w [dir=back, " + kFactLink + "];\n";
      }
    }
    for (const auto& [ends, facts] : task_links_) {
      out_ += "  " + step_name(ends.first) + " -> " + name_of(ends.second) + " [" + kTaskLink +
              ", edgetooltip=" + quoted(facts) + "];\n";
    }
  }

  std::string step_name(StepIndex step) const { return 's' + std::to_string(step); }
  std::string name_of(TreeIndex at) const {
    const TreeNode& node = tree_[at];
    return node.kind == TreeNodeKind::kStep ? step_name(node.step) : 'n' + std::to_string(at);
  }

  const Plan& plan_;
  const TermStore& store_;
  ShownTree tree_;
  std::string title_;
  std::map<std::pair<StepIndex, std::string>, std::vector<TreeIndex>> users_;  // steps, by fact
  std::map<std::pair<StepIndex, TreeIndex>, std::string> task_links_;          // facts
  std::string out_;
};

}  // namespace

std::string to_dot(const Plan& plan, const TermStore& store, const PlanGraphOptions& options) {
  return GraphWriter(plan, store, options).write();
}

}  // namespace skein::htn
