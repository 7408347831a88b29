// SPDX-License-Identifier: Apache-2.0
// What holds tasks back though all they wait for has come.
#include <algorithm>
#include <optional>
#include <vector>

#include "schedule/course_links.hpp"
#include "schedule/plan_network.hpp"

namespace skein::supervisor {

using executive::TaskId;
using temporal::Arc;
using temporal::kInfinite;
using temporal::kMinusInfinite;
using temporal::LiveNetwork;
using temporal::LiveStn;
using temporal::NodeIndex;
using temporal::Ticks;

void PlanNetwork::set_hold(LiveStn::LinkId link, const Arc& in_soonest, Ticks in_slowest) {
  held_.insert(link);
  soonest_.set(link, in_soonest);
  slowest_.set(link, {in_soonest.from, in_soonest.to, in_slowest, kInfinite});
}

void PlanNetwork::hold_back(bool controllable) {
  for (const LiveStn::LinkId link : held_) {
    soonest_.erase(link);
    slowest_.erase(link);
  }
  held_.clear();
  schedule_.holds.clear();
  hold_for_instants(controllable ? &fast_ : any_course());
  if (controllable) hold_after_goals(fast_);
  for (const temporal::NamedWait& wait : live_.waits()) hold_behind(wait);
  if (controllable) hold_for_what_is_implied();
  soonest_.settle();
  if (controllable) hold_until_windows_open();
}

// The executive holds a task with a start_after or end_after back to the date from which it may
// start.
void PlanNetwork::hold_for_instants(const LiveStn* windows) {
  if (windows == nullptr || !windows->consistent()) return;
  for (const auto& [id, known] : tasks_) {
    const mission::TimeConstraints& time = known.task.time;
    const bool held = (time.start_after && !known.seen.started) || time.end_after;
    if (!held || known.seen.over) continue;
    const Ticks from = windows->earliest(known.start);
    set_hold(kHeldUntil | known.start, {0, known.start, from, kInfinite}, from);
  }
}

// Its end waits for what stops it, which is bound in the same way: nothing holds its start back.
bool PlanNetwork::ends_with_its_like(const Known& known) const {
  const auto& stops = known.task.stop;
  return !stops.empty() && std::all_of(stops.begin(), stops.end(), [&](const auto& one) {
    const auto other = tasks_.find(one.task);
    return one.kind != mission::DependenceKind::kRunning && other != tasks_.end() &&
           other->second.bounds == known.bounds;
  });
}

// What comes so long after a goal waits for the end of its last tasks, when that is enough; else
// until the goal is over, and then for its date.
void PlanNetwork::hold_after_goals(const LiveStn& windows) {
  for (const auto& [id, known] : tasks_) {
    if (known.bounds.empty() || known.seen.started || known.seen.over) continue;
    const Ticks from = windows.earliest(known.start);
    set_hold(kHeldUntil | known.start, {0, known.start, from, kInfinite}, from);
    // Nor does its start say when a wait for orders ends.
    const bool stopped = known.endless || ends_with_its_like(known);
    std::optional<MissionTime> date;
    for (const TaskBound& one : known.bounds) {
      if (one.bound.on_end && stopped) continue;
      const Duration lasts = one.bound.on_end ? known.task.duration.least : Duration();
      const bool soon = one.bound.least <= lasts;
      if (one.other == TaskId()) {
        if (!soon) date = std::max(date.value_or(one.over), one.over + one.bound.least - lasts);
      } else if (tasks_.count(one.other) != 0 && !(soon && one.bound.on_end)) {
        schedule_.holds[id].push_back({soon ? one.other : TaskId(), MissionTime::max()});
      }
    }
    if (date) schedule_.holds[id].push_back({TaskId(), *date});
  }
}

void PlanNetwork::hold_behind(const temporal::NamedWait& wait) {
  const TaskId task = wait.node < starts_.size() ? starts_[wait.node] : TaskId();
  const auto known = tasks_.find(task);
  if (known == tasks_.end() || known->second.start != wait.node || known->second.seen.started)
    return;
  const temporal::LiveLink& link = live_.link(wait.link);
  const NodeIndex activation = *live_.index(link.from);
  const LiveStn::LinkId name = between(kHeldBehind, activation, wait.node);
  set_hold(name, {activation, wait.node, std::min(wait.delay, link.min), kInfinite}, wait.delay);
  const TaskId on(wait.link.key);
  const Duration delay = Duration::nanoseconds(wait.delay);
  // Others come at a date, whenever it starts that waits for them.
  const bool dated = link.from == LiveNetwork::kOrigin;
  const auto since = dated ? std::optional(MissionTime()) : tasks_.at(on).seen.started;
  schedule_.holds[task].push_back({on, since ? *since + delay : MissionTime::max()});
}

// Without instants, which windows are made of, and the past.
ImpliedBounds PlanNetwork::bounds_by_name() const {
  ImpliedBounds bounds(std::max<std::size_t>(starts_.size(), present_ + 1U));
  bounds.set_past(0);
  bounds.set_past(present_);
  for (const auto& [id, known] : tasks_) {
    if (known.seen.started || known.seen.over) bounds.set_past(known.start);
    if (known.seen.over) bounds.set_past(known.end);
    for (const auto& [name, one] : known.links) {
      const NodeIndex from = *live_.index(one.link.from), to = *live_.index(one.link.to);
      if (one.link.max != kInfinite) bounds.add(from, to, one.link.max, false);
      if (one.link.min != kMinusInfinite) bounds.add(to, from, -one.link.min, true);
    }
  }
  for (const auto& [link, arc] : implied_) bounds.add(arc.from, arc.to, arc.max, false);
  for (const temporal::NamedWait& wait : live_.waits()) {
    const temporal::LiveLink& link = live_.link(wait.link);
    bounds.add(wait.node, *live_.index(link.from), -std::min(wait.delay, link.min), true);
  }
  for (const auto& [id, known] : tasks_)
    for (const auto& [name, one] : known.links)
      if (one.link.contingent && one.cause.kind == BoundKind::kDuration)
        bounds.may_last(known.start, known.end, one.link.min);
  return bounds;
}

// What must not come too long before another waits for what that waits for. A date is told when it
// is known.
void PlanNetwork::hold_for_what_is_implied() {
  const ImpliedBounds bounds = bounds_by_name();
  for (const auto& [id, known] : tasks_) {
    if (known.seen.started || known.seen.over) continue;
    bool waits = false;
    for (const ImpliedBounds::Bound& one : bounds.of(known.start)) {
      set_hold(between(kHeldAfter, one.node, known.start),
               {one.node, known.start, one.least, kInfinite}, one.least);
      waits = true;
    }
    if (waits) schedule_.holds[id].push_back({TaskId(), MissionTime::max()});
  }
}

// What its conditions would let start before its window opens.
void PlanNetwork::hold_until_windows_open() {
  if (!soonest_.consistent() || !fast_.consistent()) return;
  std::vector<const Known*> early;
  for (const auto& [id, known] : tasks_) {
    const bool to_come = !known.seen.started && !known.seen.over;
    if (to_come && soonest_.earliest(known.start) < fast_.earliest(known.start))
      early.push_back(&known);
  }
  for (const Known* known : early) {
    const Ticks from = fast_.earliest(known->start);
    set_hold(kHeldUntil | known->start, {0, known->start, from, kInfinite}, from);
    schedule_.holds[known->task.id].push_back({TaskId(), MissionTime::nanoseconds(from)});
  }
}

}  // namespace skein::supervisor
