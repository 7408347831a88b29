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
/// Who is so much later than he foresaw comes at no known date. So long it takes at most until all
/// know that all are there.
constexpr Duration kLate = Duration::milliseconds(1000);

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
  Links(const TaskView& view, MissionTime now, const SeenOf& seen)
      : view_(view),
        task_(*view.task),
        bounds_(view.bounds),
        encounter_(view.encounter),
        now_(now),
        seen_(seen),
        own_(view.seen),
        start_(start_of(task_.id)),
        end_(end_of(task_.id)) {}

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
    if (!task_.stop.empty()) {
      stop();
    } else if (encounter_ && encounter_->for_air) {
      wait_for_air();
    } else if (encounter_ && encounter_->awaits() && !encounter_->at_start) {
      meet();
    } else {
      last();
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
    if (is_endless(view_, now_)) {
      add(BoundKind::kDuration, start_, end_, {span.least, kInfinite});
      if (own_.started) add(BoundKind::kNow, kPresent, end_, {0, kInfinite});
      return;
    }
    const bool fixed = span.fixed();
    const Ticks least = fixed ? span.least : std::max(span.least, gone_of(own_, now_));
    add(BoundKind::kDuration, start_, end_, {least, span.most});
    links_.back().link.contingent = !fixed;
  }

  // It takes as long as the last of the others is away.
  void meet() {
    const temporal::PartnerDates& with = encounter_->with;
    const bool endless = is_endless(view_, now_);
    const bool there = with.all_there && !endless;
    const Ticks least = there ? std::max(kInstant, gone_of(own_, now_)) : kInstant;
    add(BoundKind::kDuration, start_, end_, {least, there ? kLate.count() : kInfinite});
    links_.back().link.contingent = there;
    if (own_.started && !there) add(BoundKind::kNow, kPresent, end_, {0, kInfinite});
    if (with.all_there) return;
    come(with, !endless, others_at(task_.id));
    add(BoundKind::kPartner, others_at(task_.id), end_, {0, kInfinite}, {}, 1);
    links_.back().cause.who = with.last;
  }

  // It has not begun to fly.
  void wait_for_air() {
    const Span span = span_of(task_);
    const bool bounded = !is_endless(view_, now_);
    const NodeName air = others_at(task_.id);
    temporal::PartnerDates leaving = encounter_->with;
    leaving.soonest = now_;
    come(leaving, bounded, air);
    links_.back().cause.part = kAirPart;
    add(BoundKind::kNow, kPresent, end_, {span.least, kInfinite});
    add(BoundKind::kDuration, air, end_, {span.least, span.most});
    links_.back().link.contingent = span.bounded() && !span.fixed();
  }

  // When it begins is agreed upon, with all that nature has decided by then: what counts now is how
  // soon the others can.
  void gather(const temporal::PartnerDates& with) {
    if (with.last.empty() || with.all_there || with.soonest.count() > kHorizon) return;
    add(BoundKind::kPartner, LiveNetwork::kOrigin, start_, {ticks_of(with.soonest), kInfinite});
    links_.back().cause.who = with.last;
  }

  void come(const temporal::PartnerDates& with, bool bounded, NodeName others) {
    const Ticks least = std::max<Ticks>({ticks_of(with.soonest), ticks_of(now_), 1});
    const Ticks most = std::max(ticks_of(with.slowest), least + kInstant);
    add(BoundKind::kPartner, LiveNetwork::kOrigin, others, {least, bounded ? most : kInfinite});
    links_.back().link.contingent =
        bounded && encounter_->reliance == Meetings::Reliance::kOnNothing;
    links_.back().cause.who = with.last;
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
    if (encounter_ && encounter_->at_start) gather(encounter_->with);
    const bool counts = encounter_ && encounter_->reliance != Meetings::Reliance::kNobodysNeeds;
    if (!counts || !encounter_->with.needed) return;
    not_after(start_, encounter_->with.needed, BoundKind::kNeeded);
    if (links_.back().cause.kind == BoundKind::kNeeded)
      links_.back().cause.who = encounter_->with.needed_by;
  }
  void end_constraints() {
    not_before(end_, task_.time.end_after, BoundKind::kEndAfter);
    not_after(end_, task_.time.end_before, BoundKind::kEndBefore);
  }

  const TaskView& view_;
  const ElementaryTask& task_;
  const std::vector<TaskBound>& bounds_;
  const std::optional<Encounter>& encounter_;
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

std::optional<PlanMeeting> meeting_of(const ElementaryTask& task) {
  if (task.gathering) {
    const mission::Gathering& with = *task.gathering;
    return PlanMeeting{{with.id, with.members, with.members}, true};
  }
  if (!task.synchronisation) return std::nullopt;
  const executive::Synchronisation& with = *task.synchronisation;
  return PlanMeeting{{with.id, with.senders, with.receivers}, false};
}

std::vector<PlanLink> links_of(const TaskView& view, MissionTime now, const SeenOf& seen) {
  return Links(view, now, seen).all();
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

namespace {

bool waits_for_air(const TaskView& view, const Meetings& meetings) {
  return meetings.air.waits == view.task->id && view.seen.started && !view.seen.over;
}

}  // namespace

void relate(std::vector<TaskView>& tasks, const GoalBounds& bounds) {
  for (TaskView& view : tasks) {
    view.bounds.clear();
    view.encounter.reset();
  }
  for (const auto& [goal, all] : bounds.of) {
    for (const mission::GoalBound& one : all) {
      const std::vector<TaskBound> after = bounds_after(one, tasks, bounds);
      for (TaskView& view : tasks) {
        if (view.task->origin == goal)
          view.bounds.insert(view.bounds.end(), after.begin(), after.end());
      }
    }
  }
  // One whose end has to wait for a date begins no sooner than that: it might end at once.
  const auto waits_for_date = [](const TaskView& view) {
    return view.task->time.end_after ||
           std::any_of(view.bounds.begin(), view.bounds.end(),
                       [](const TaskBound& one) { return one.bound.on_end; });
  };
  for (TaskView& view : tasks) {
    if (waits_for_air(view, bounds.meetings)) {
      const auto known = bounds.meetings.of.find(temporal::order_of(bounds.meetings.air.uav));
      if (known != bounds.meetings.of.end() && !known->second.last.empty())
        view.encounter = Encounter{known->second, false, true, bounds.meetings.reliance};
      continue;
    }
    const auto meeting = meeting_of(*view.task);
    if (!meeting || view.seen.over || (!meeting->at_start && waits_for_date(view))) continue;
    const auto met = bounds.meetings.of.find(meeting->what.id);
    if (met == bounds.meetings.of.end()) continue;
    view.encounter = Encounter{met->second, meeting->at_start, false, bounds.meetings.reliance};
    // Who cannot keep to what was agreed asks for another date.
    if (meeting->at_start && view.task->gathering->agreed) view.encounter->with.last.clear();
  }
}

bool is_endless(const TaskView& view, MissionTime now) {
  const ElementaryTask& task = *view.task;
  const Observation& seen = view.seen;
  if (seen.over || !task.stop.empty()) return false;
  if (view.encounter && view.encounter->for_air)
    return !span_of(task).bounded() || view.encounter->with.slowest.count() > kHorizon;
  if (view.encounter && view.encounter->awaits() && !view.encounter->at_start) {
    const temporal::PartnerDates& with = view.encounter->with;
    if (with.all_there) return seen.started && gone_of(seen, now) >= kLate.count();
    return with.slowest.count() > kHorizon || with.slowest + kLate <= now;
  }
  const Span span = span_of(task);
  return !span.bounded() || (seen.started && gone_of(seen, now) >= span.most);
}

}  // namespace skein::supervisor
