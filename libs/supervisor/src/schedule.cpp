// SPDX-License-Identifier: Apache-2.0
// Verdict and dates of a plan.
#include "skein/supervisor/schedule.hpp"

#include <algorithm>

#include "companions.hpp"
#include "network.hpp"
#include "schedule_conflicts.hpp"
#include "schedule_dates.hpp"
#include "skein/temporal/stnu_controllability.hpp"

namespace skein::supervisor {

namespace {

using mission::ElementaryTask;
using temporal::Ticks;

MissionTime instant_of(Ticks date) {
  return date == temporal::kInfinite ? MissionTime::max() : MissionTime::nanoseconds(date);
}

std::map<executive::TaskId, mission::TaskDates> by_task(const PlanNetwork& plan,
                                                        const NodeDates& dates) {
  std::map<executive::TaskId, mission::TaskDates> result;
  for (const auto& [id, nodes] : plan.nodes) {
    result[id] = {instant_of(dates.earliest[nodes.start]), instant_of(dates.latest[nodes.start]),
                  instant_of(dates.earliest[nodes.end]), instant_of(dates.latest[nodes.end])};
  }
  return result;
}

void set_end(Schedule& schedule) {
  bool first = true;
  for (const auto& [id, dates] : schedule.foreseen) {
    const auto later = [&](MissionTime a, MissionTime b) { return first ? b : std::max(a, b); };
    schedule.earliest_end = later(schedule.earliest_end, dates.earliest_end);
    schedule.latest_end = later(schedule.latest_end, dates.latest_end);
    first = false;
  }
}

}  // namespace

Schedule schedule(const std::vector<ElementaryTask>& tasks, const Observations& seen,
                  MissionTime now) {
  Schedule result;
  const PlanNetwork plan = build_network(tasks, seen, now);
  const auto verdict = temporal::check_dynamic_controllability(plan.stnu);
  if (!verdict) {
    const executive::TaskId first = tasks.empty() ? executive::TaskId() : tasks.front().id;
    result.conflicts = {
        {first, "the plan cannot be dated: " + to_text(verdict.error(), plan.stnu)}};
    return result;
  }
  result.consistent = verdict->consistent;
  std::optional<NodeDates> allowed;
  if (verdict->controllable) allowed = dates_in_every_course(plan);
  if (!allowed && verdict->consistent) allowed = dates_by_choice(plan);
  const auto foreseen = foresee(plan, allowed ? &*allowed : nullptr);
  if (!verdict->controllable) {
    result.conflicts = explain(plan, *verdict, foreseen ? &*foreseen : nullptr);
  } else if (allowed && foreseen) {
    result.conflicts = late_companions(plan, *allowed, *foreseen, now);
  }
  result.controllable = verdict->controllable && result.conflicts.empty();
  if (verdict->controllable && !result.controllable) allowed = dates_by_choice(plan);
  if (!allowed || !foreseen) return result;
  result.dates = by_task(plan, *allowed);
  result.foreseen = by_task(plan, *foreseen);
  set_end(result);
  return result;
}

}  // namespace skein::supervisor
