// SPDX-License-Identifier: Apache-2.0
// The rules of schedule.hpp, task by task.
#include "schedule/plan_links.hpp"

#include <algorithm>
#include <optional>

namespace skein::supervisor {

namespace {

using mission::DependenceKind;
using mission::ElementaryTask;
using temporal::kInfinite;
using temporal::kMinusInfinite;
using temporal::LiveNetwork;
using temporal::NodeName;
using temporal::Ticks;

/// Figures beyond are unbounded, so that sums over a thousand tasks stay within the engines' range.
constexpr Ticks kHorizon = Ticks{1} << 50;
/// The least that nature takes for anything.
constexpr Ticks kInstant = 1'000'000;

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

Ticks gone_of(const Observation& seen, MissionTime now) {
  return seen.started ? ticks_of(now) - ticks_of(*seen.started) : 0;
}

class Links {
 public:
  Links(const ElementaryTask& task, const std::vector<TaskBound>& bounds, MissionTime now,
        const SeenOf& seen)
      : task_(task),
        bounds_(bounds),
        now_(now),
        seen_(seen),
        own_(*seen(task.id)),
        start_(start_of(task.id)),
        end_(end_of(task.id)) {}

  std::vector<PlanLink> all() {
    if (own_.over) {
      fact(start_, own_.started.value_or(*own_.over), 0);
      fact(end_, *own_.over, 1);
      return std::move(links_);
    }
    if (own_.started) {
      fact(start_, *own_.started, 0);
    } else {
      add(BoundKind::kNow, kPresent, start_, {0, kInfinite});
      for (const mission::Dependence& one : task_.dependences) depend(one);
      start_constraints();
    }
    if (task_.stop.empty()) {
      last();
    } else {
      stop();
    }
    end_constraints();
    for (std::uint32_t i = 0; i < bounds_.size(); ++i) after(bounds_[i], i);
    return std::move(links_);
  }

 private:
  struct Between {
    Ticks least, most;
  };
  void add(BoundKind kind, NodeName from, NodeName to, Between bounds, executive::TaskId other = {},
           std::uint32_t part = 0) {
    if (from == to) return;  // only of a task that names itself: it waits for nothing
    links_.push_back(
        {{task_.id, kind, other, {}, part}, {from, to, bounds.least, bounds.most, false}});
  }
  void fact(NodeName node, MissionTime date, std::uint32_t part) {
    add(BoundKind::kFact, LiveNetwork::kOrigin, node, {ticks_of(date), ticks_of(date)}, {}, part);
    links_.back().cause.instant = date;
  }
  void not_before(NodeName node, const std::optional<MissionTime>& date, BoundKind kind) {
    if (!date) return;
    add(kind, LiveNetwork::kOrigin, node, {ticks_of(*date), kInfinite});
    links_.back().cause.instant = *date;
  }
  void not_after(NodeName node, const std::optional<MissionTime>& date, BoundKind kind) {
    if (!date || date->count() > kHorizon) return;
    add(kind, LiveNetwork::kOrigin, node, {kMinusInfinite, ticks_of(*date)});
    links_.back().cause.instant = *date;
  }

  void depend(const mission::Dependence& one) {
    const Observation* theirs = seen_(one.task);
    if (theirs == nullptr) return;
    if (one.kind != DependenceKind::kRunning) {
      return add(BoundKind::kAfterEnd, end_of(one.task), start_, {0, kInfinite}, one.task);
    }
    add(BoundKind::kAfterStart, start_of(one.task), start_, {0, kInfinite}, one.task);
    // One under way may end at any moment: there is no more than this one to start in.
    const Ticks margin = theirs->started ? 0 : kStartMargin.count();
    add(BoundKind::kWithin, end_of(one.task), start_, {kMinusInfinite, -margin}, one.task);
  }

  // Nature ends the task, or its duration is known.
  void last() {
    const Span span = span_of(task_);
    if (is_endless(task_, own_, now_)) {
      add(BoundKind::kDuration, start_, end_, {span.least, kInfinite});
      if (own_.started) add(BoundKind::kNow, kPresent, end_, {0, kInfinite});
      return;
    }
    const bool fixed = span.fixed();
    const Ticks least = fixed ? span.least : std::max(span.least, gone_of(own_, now_));
    add(BoundKind::kDuration, start_, end_, {least, span.most});
    links_.back().link.contingent = !fixed;
  }

  void stop() {
    add(BoundKind::kOrder, start_, end_, {0, kInfinite});
    if (own_.started) add(BoundKind::kNow, kPresent, end_, {0, kInfinite});
    for (const mission::Dependence& one : task_.stop) stop(one);
  }

  void stop(const mission::Dependence& one) {
    const Observation* theirs = seen_(one.task);
    if (theirs == nullptr) return;
    const bool at_start = one.kind == DependenceKind::kRunning;
    const auto part = static_cast<std::uint32_t>(one.kind);
    const NodeName event = at_start ? start_of(one.task) : end_of(one.task);
    const bool to_come = at_start ? !theirs->started && !theirs->over : !theirs->over;
    const bool only = task_.stop.size() == 1;
    const bool at_once = only && to_come && !task_.time.end_after;
    add(BoundKind::kStop, event, end_, {0, at_once ? kStopReaction.count() : kInfinite}, one.task,
        part);
    if (only && !own_.started) {
      add(BoundKind::kBeforeStop, event, start_, {kMinusInfinite, 0}, one.task, part);
    }
  }

  // What has started keeps its start: facts break nothing.
  void after(const TaskBound& one, std::uint32_t number) {
    const bool over = one.other == executive::TaskId();
    if ((own_.started && !one.bound.on_end) || (!over && seen_(one.other) == nullptr)) return;
    const Ticks from = over ? ticks_of(one.over) : 0;
    const Ticks most =
        one.bound.most.count() > kHorizon ? kInfinite : from + one.bound.most.count();
    const Ticks least = from + std::clamp<Ticks>(one.bound.least.count(), 0, kHorizon);
    add(BoundKind::kAfterGoal, over ? LiveNetwork::kOrigin : end_of(one.other),
        one.bound.on_end ? end_ : start_, {least, most}, one.other, number % 8);
    links_.back().cause.goal = one.bound.goal;
    links_.back().cause.instant = one.over;
  }

  void start_constraints() {
    not_before(start_, task_.time.start_after, BoundKind::kStartAfter);
    not_after(start_, task_.time.start_before, BoundKind::kStartBefore);
  }
  void end_constraints() {
    not_before(end_, task_.time.end_after, BoundKind::kEndAfter);
    not_after(end_, task_.time.end_before, BoundKind::kEndBefore);
  }

  const ElementaryTask& task_;
  const std::vector<TaskBound>& bounds_;
  MissionTime now_;
  const SeenOf& seen_;
  const Observation& own_;
  NodeName start_, end_;
  std::vector<PlanLink> links_;
};

}  // namespace

temporal::Ticks ticks_of(MissionTime instant) {
  return std::clamp(instant.count(), -kHorizon, kHorizon);
}

temporal::LinkName name_of(const Cause& cause) {
  const std::uint32_t kind = 8 * static_cast<std::uint32_t>(cause.kind) + cause.part;
  return {0, cause.task.value(), kind, cause.other.value()};
}

std::vector<PlanLink> links_of(const ElementaryTask& task, const std::vector<TaskBound>& bounds,
                               MissionTime now, const SeenOf& seen) {
  return Links(task, bounds, now, seen).all();
}

namespace {

// No other task of its goal follows it.
bool is_last(const ElementaryTask& task, const std::vector<TaskView>& tasks) {
  return std::none_of(tasks.begin(), tasks.end(), [&](const TaskView& other) {
    const auto names = [&](const mission::Dependence& one) { return one.task == task.id; };
    const ElementaryTask& its = *other.task;
    return its.origin == task.origin &&
           (std::any_of(its.dependences.begin(), its.dependences.end(), names) ||
            std::any_of(its.stop.begin(), its.stop.end(), names));
  });
}

std::vector<TaskBound> bounds_after(const mission::GoalBound& bound,
                                    const std::vector<TaskView>& tasks, const GoalBounds& bounds) {
  const auto over = bounds.over.find(bound.goal);
  if (over != bounds.over.end()) return {{bound, executive::TaskId(), over->second}};
  std::vector<TaskBound> result;
  for (const TaskView& other : tasks) {
    if (other.task->origin == bound.goal && is_last(*other.task, tasks))
      result.push_back({bound, other.task->id, {}});
  }
  return result;
}

}  // namespace

void relate(std::vector<TaskView>& tasks, const GoalBounds& bounds) {
  for (const auto& [goal, all] : bounds.of) {
    for (const mission::GoalBound& one : all) {
      const std::vector<TaskBound> after = bounds_after(one, tasks, bounds);
      for (TaskView& view : tasks) {
        if (view.task->origin == goal)
          view.bounds.insert(view.bounds.end(), after.begin(), after.end());
      }
    }
  }
}

bool is_endless(const ElementaryTask& task, const Observation& seen, MissionTime now) {
  if (seen.over || !task.stop.empty()) return false;
  const Span span = span_of(task);
  return !span.bounded() || (seen.started && gone_of(seen, now) >= span.most);
}

}  // namespace skein::supervisor
