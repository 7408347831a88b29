// SPDX-License-Identifier: Apache-2.0
#include "deliberation_lines.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/journal/lines/deliberation.hpp"

#include <algorithm>

namespace skein::ddn {

namespace lines = journal::lines;

namespace {

/// "ended 100, running 102".
std::string text_of(const std::vector<wire::TaskDependence>& dependences) {
  std::string text;
  for (const wire::TaskDependence& one : dependences) {
    text += (text.empty() ? "" : ", ") + std::string(name_of(one.kind)) + " " +
            std::to_string(one.task);
  }
  return text;
}

double seconds(std::int64_t count) {
  return journal::rounded(MissionTime::nanoseconds(count).to_seconds());
}

/// Left out when there is no such bound.
std::optional<double> bound(std::int64_t count) {
  if (count == wire::kNever) return std::nullopt;
  return seconds(count);
}

void tell_estimate(lines::Answer& line, const mission::MissionEstimate& estimate) {
  line.placement = mission::to_text(estimate.placement);
  line.cost = estimate.cost;
  line.energy = estimate.energy;
  line.earliest_end = estimate.earliest_end.to_seconds();
  if (estimate.latest_end != MissionTime::max()) line.latest_end = estimate.latest_end.to_seconds();
}

}  // namespace

journal::Record plan_line(const translation::Writer& writer, const mission::PlanReport& report) {
  lines::Plan line{.uav = writer.node,
                   .revision = report.revision,
                   .tasks = report.tasks.size(),
                   .goals = report.goals.size()};
  if (report.tasks.empty()) return writer.record(std::move(line));
  MissionTime earliest = report.tasks.front().dates.earliest_end;
  MissionTime latest = report.tasks.front().dates.latest_end;
  for (const mission::PlannedTask& task : report.tasks) {
    earliest = std::max(earliest, task.dates.earliest_end);
    latest = std::max(latest, task.dates.latest_end);
  }
  line.earliest_end = bound(earliest.count());
  line.latest_end = bound(latest.count());
  return writer.record(std::move(line));
}

journal::Record planned_line(const translation::Writer& writer, std::uint64_t revision,
                             const wire::PlanEntry& task, const executive::Parameters& parameters) {
  return writer.record(lines::Planned{.uav = writer.node,
                                      .revision = revision,
                                      .task = task.id,
                                      .type = task.type,
                                      .goal = task.origin,
                                      .earliest_start = seconds(task.earliest_start),
                                      .device = translation::device_of(parameters),
                                      .target = translation::target_of(parameters),
                                      .latest_start = bound(task.latest_start),
                                      .earliest_end = seconds(task.earliest_end),
                                      .latest_end = bound(task.latest_end),
                                      .after = text_of(task.dependences),
                                      .stop = text_of(task.stop),
                                      .methods = task.methods,
                                      .committed = task.committed,
                                      .way = journal::rounded(task.way)});
}

journal::Record outcome_line(const translation::Writer& writer,
                             const mission::MissionOutcome& outcome) {
  lines::Answer line{.uav = writer.node,
                     .mission = outcome.mission.value(),
                     .planned = outcome.planned,
                     .why = joined(outcome.reasons, "; ")};
  if (outcome.evaluated) line.evaluated = true;
  if (outcome.estimate) tell_estimate(line, *outcome.estimate);
  return writer.record(std::move(line));
}

journal::Record goal_line(const translation::Writer& writer, const mission::GoalStatus& goal) {
  return writer.record(lines::Goal{.uav = writer.node,
                                   .goal = goal.id.value(),
                                   .mission = goal.mission.value(),
                                   .statement = goal.statement,
                                   .state = to_text(goal.state),
                                   .why = goal.why,
                                   .asked_by = goal.asked_by,
                                   .done = goal.done});
}

journal::Record decision_line(const translation::Writer& writer,
                              const mission::Decision& decision) {
  return writer.record(lines::Decision{.uav = writer.node,
                                       .number = decision.number,
                                       .operator_ = decision.applied,
                                       .cause = decision.cause,
                                       .inputs = decision.inputs,
                                       .outcome = decision.outcome,
                                       .took = journal::rounded(decision.took.to_seconds())});
}

}  // namespace skein::ddn
