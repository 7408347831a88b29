// SPDX-License-Identifier: Apache-2.0
// Builds the network of a plan, task by task. The rules are in schedule.hpp.
#include "rebuilt_network.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::supervisor {

namespace {

using mission::DependenceKind;
using mission::ElementaryTask;
using temporal::kInfinite;
using temporal::kMinusInfinite;
using temporal::NodeIndex;
using temporal::Ticks;

/// Figures beyond are unbounded, so that sums over a thousand tasks stay within the engines' range.
constexpr Ticks kHorizon = Ticks{1} << 50;
/// The least that nature takes for anything.
constexpr Ticks kInstant = 1'000'000;

Ticks clamped(MissionTime instant) { return std::clamp(instant.count(), -kHorizon, kHorizon); }

struct Span {
  Ticks least = 0, most = kInfinite;
  bool fixed() const { return least == most; }
  bool bounded() const { return most != kInfinite; }
};

Span span_of(const ElementaryTask& task) {
  const Ticks least = std::clamp<Ticks>(task.duration.least.count(), 0, kHorizon);
  if (task.open_ended || task.duration.most.count() > kHorizon) return {least, kInfinite};
  const Ticks most = std::max(least, task.duration.most.count());
  if (least > 0 || most == 0) return {least, most};
  // What nature decides takes some time at least.
  return {std::min(kInstant, most), most};
}

class Builder {
 public:
  Builder(const std::vector<ElementaryTask>& tasks, const Observations& seen, MissionTime now)
      : tasks_(tasks), seen_(seen), now_(now) {}

  RebuiltNetwork build() {
    result_.stnu.nodes.emplace_back("0");
    for (const ElementaryTask& task : tasks_) {
      const auto start = static_cast<NodeIndex>(result_.stnu.nodes.size());
      const bool is_new = result_.nodes.emplace(task.id, TaskNodes{start, start + 1}).second;
      SKEIN_EXPECTS(is_new);
      result_.stnu.nodes.push_back(to_text(task.id) + " start");
      result_.stnu.nodes.push_back(to_text(task.id) + " end");
    }
    for (const ElementaryTask& task : tasks_) add(task);
    return std::move(result_);
  }

 private:
  Observation seen_of(executive::TaskId task) const {
    const auto found = seen_.find(task);
    return found == seen_.end() ? Observation() : found->second;
  }

  void add(const ElementaryTask& task) {
    task_ = task.id;
    own_ = result_.nodes.at(task.id);
    const Observation seen = seen_of(task.id);
    if (seen.over) {
      fact(own_.start, seen.started.value_or(*seen.over));
      fact(own_.end, *seen.over);
      return;
    }
    if (seen.started) {
      fact(own_.start, *seen.started);
    } else {
      not_before(own_.start, now_, RuleKind::kNow);
      for (const mission::Dependence& one : task.dependences) depend(one);
      start_constraints(task.time);
    }
    if (task.stop.empty()) {
      last(span_of(task), seen);
    } else {
      stop(task, seen);
    }
    end_constraints(task.time);
  }

  void link(NodeIndex from, NodeIndex to, Ticks least, Ticks most, Rule cause) {
    if (from == to) return;  // only of a task that names itself: it waits for nothing
    result_.stnu.arcs.push_back({from, to, least, most});
    result_.arcs.push_back(cause);
  }
  void fact(NodeIndex node, MissionTime at) {
    link(0, node, clamped(at), clamped(at), {task_, RuleKind::kFact, {}, at});
  }
  void not_before(NodeIndex node, MissionTime at, RuleKind kind) {
    link(0, node, clamped(at), kInfinite, {task_, kind, {}, at});
  }
  void not_after(NodeIndex node, MissionTime at, RuleKind kind) {
    if (at.count() > kHorizon) return;
    link(0, node, kMinusInfinite, clamped(at), {task_, kind, {}, at});
  }

  void depend(const mission::Dependence& one) {
    const auto other = result_.nodes.find(one.task);
    if (other == result_.nodes.end()) return;
    const TaskNodes& nodes = other->second;
    if (one.kind != DependenceKind::kRunning) {
      link(nodes.end, own_.start, 0, kInfinite, {task_, RuleKind::kAfterEnd, one.task, {}});
      return;
    }
    link(nodes.start, own_.start, 0, kInfinite, {task_, RuleKind::kAfterStart, one.task, {}});
    const Ticks margin = seen_of(one.task).started ? 0 : kStartMargin.count();
    link(nodes.end, own_.start, kMinusInfinite, -margin, {task_, RuleKind::kWithin, one.task, {}});
  }

  // Nature ends the task, or its duration is known.
  void last(const Span& span, const Observation& seen) {
    const Rule cause{task_, RuleKind::kDuration, {}, {}};
    const Ticks gone = seen.started ? clamped(now_) - clamped(*seen.started) : 0;
    const bool overdue = seen.started && span.bounded() && gone >= span.most;
    if (!span.bounded() || overdue) {
      result_.endless.push_back(own_.end);
      link(own_.start, own_.end, span.least, kInfinite, cause);
      if (seen.started) not_before(own_.end, now_, RuleKind::kNow);
    } else if (span.fixed()) {
      link(own_.start, own_.end, span.least, span.most, cause);
    } else {
      const Ticks least = std::max(span.least, gone);
      result_.stnu.contingent.push_back({own_.start, own_.end, least, span.most});
      result_.contingent.push_back(cause);
    }
  }

  void stop(const ElementaryTask& task, const Observation& seen) {
    link(own_.start, own_.end, 0, kInfinite, {task_, RuleKind::kOrder, {}, {}});
    if (seen.started) not_before(own_.end, now_, RuleKind::kNow);
    for (const mission::Dependence& one : task.stop) {
      const auto other = result_.nodes.find(one.task);
      if (other == result_.nodes.end()) continue;
      const bool at_start = one.kind == DependenceKind::kRunning;
      const NodeIndex event = at_start ? other->second.start : other->second.end;
      const Observation theirs = seen_of(one.task);
      const bool to_come = at_start ? !theirs.started && !theirs.over : !theirs.over;
      const bool at_once = task.stop.size() == 1 && to_come && !task.time.end_after;
      link(event, own_.end, 0, at_once ? kStopReaction.count() : kInfinite,
           {task_, RuleKind::kStop, one.task, {}});
      if (task.stop.size() == 1 && !seen.started) {
        link(event, own_.start, kMinusInfinite, 0, {task_, RuleKind::kBeforeStop, one.task, {}});
      }
    }
  }

  void start_constraints(const mission::TimeConstraints& time) {
    if (time.start_after) not_before(own_.start, *time.start_after, RuleKind::kStartAfter);
    if (time.start_before) not_after(own_.start, *time.start_before, RuleKind::kStartBefore);
  }
  void end_constraints(const mission::TimeConstraints& time) {
    if (time.end_after) not_before(own_.end, *time.end_after, RuleKind::kEndAfter);
    if (time.end_before) not_after(own_.end, *time.end_before, RuleKind::kEndBefore);
  }

  const std::vector<ElementaryTask>& tasks_;
  const Observations& seen_;
  MissionTime now_;
  RebuiltNetwork result_;
  executive::TaskId task_;
  TaskNodes own_;
};

}  // namespace

RebuiltNetwork build_network(const std::vector<ElementaryTask>& tasks, const Observations& seen,
                             MissionTime now) {
  return Builder(tasks, seen, now).build();
}

temporal::Stnu network_of(const std::vector<ElementaryTask>& tasks, const Observations& seen,
                          MissionTime now) {
  return build_network(tasks, seen, now).stnu;
}

}  // namespace skein::supervisor
