// SPDX-License-Identifier: Apache-2.0
// Where a search failed, and where it stands.
#include <algorithm>

#include "search/search.hpp"

namespace skein::htn {

void Search::dead_end(NodeId node, Term task) {
  const std::uint64_t expansion = budget_->expansions();
  if (explain_at_) {
    if (explain_at_->expansion == expansion && !failure_) {
      failure_ = point_at(node);
      failure_->attempts = explainer().attempts(task, *steps_made_);
      budget_->stop("explained");
    }
    return;
  }
  const bool further =
      steps_.size() > course_.deepest_failure.steps ||
      (steps_.size() == course_.deepest_failure.steps && depth_ >= course_.deepest_failure.depth);
  if (further) course_.deepest_failure = {expansion, steps_.size(), depth_};
}

FailurePoint Search::point_at(NodeId node) {
  FailurePoint point;
  for (const StepRecord& step : steps_) {
    const Term name = store_.car(step.action);
    if (store_.name(name) == "!!inop") continue;
    point.steps.push_back({step.action, step.cost, internal(store_, name)});
  }
  for (NodeId at = node; at != kNoNodeId; at = agenda_[at].parent) {
    if (agenda_[at].kind == NetworkKind::kTask) {
      point.open_tasks.push_back(bindings_.instance(agenda_[at].task, 0));
    }
  }
  std::reverse(point.open_tasks.begin(), point.open_tasks.end());
  return point;
}

std::optional<FailurePoint> Search::standing() {
  if (cut_) return cut_;
  if (agenda_.empty()) return {};
  const NodeId immediate = agenda_.first_immediate();
  return point_at(immediate != kNoNodeId ? immediate : agenda_.first());
}

}  // namespace skein::htn
