// SPDX-License-Identifier: Apache-2.0
#include "deliberation_lines.hpp"
#include "skein/foundation/joined.hpp"

#include <algorithm>

namespace skein::ddn {

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
void with_bound(journal::Record& line, const char* key, std::int64_t count) {
  if (count != wire::kNever) line.with(key, seconds(count));
}

void tell_estimate(journal::Record& line, const mission::MissionEstimate& estimate) {
  line.with("placement", std::string(mission::to_text(estimate.placement)))
      .with("cost", estimate.cost)
      .with("energy", estimate.energy)
      .with("earliest_end", estimate.earliest_end.to_seconds());
  if (estimate.latest_end == MissionTime::max()) return;
  line.with("latest_end", estimate.latest_end.to_seconds());
}

}  // namespace

journal::Record plan_line(const translation::Writer& writer, const mission::PlanReport& report) {
  journal::Record line(writer.at, writer.node, "plan");
  line.with("uav", writer.node)
      .with("revision", report.revision)
      .with("tasks", static_cast<std::int64_t>(report.tasks.size()))
      .with("goals", static_cast<std::int64_t>(report.goals.size()));
  if (report.tasks.empty()) return line;
  MissionTime earliest = report.tasks.front().dates.earliest_end;
  MissionTime latest = report.tasks.front().dates.latest_end;
  for (const mission::PlannedTask& task : report.tasks) {
    earliest = std::max(earliest, task.dates.earliest_end);
    latest = std::max(latest, task.dates.latest_end);
  }
  with_bound(line, "earliest_end", earliest.count());
  with_bound(line, "latest_end", latest.count());
  return line;
}

journal::Record planned_line(const translation::Writer& writer, std::uint64_t revision,
                             const wire::PlanEntry& task, const executive::Parameters& parameters) {
  journal::Record line(writer.at, writer.node, "planned");
  line.with("uav", writer.node)
      .with("revision", revision)
      .with("task", task.id)
      .with("type", task.type)
      .with("goal", task.origin)
      .with("earliest_start", seconds(task.earliest_start));
  translation::with_device_and_target(line, parameters);
  with_bound(line, "latest_start", task.latest_start);
  line.with("earliest_end", seconds(task.earliest_end));
  with_bound(line, "latest_end", task.latest_end);
  line.with("after", text_of(task.dependences));
  if (!task.stop.empty()) line.with("stop", text_of(task.stop));
  line.with("methods", task.methods).with("committed", task.committed);
  if (!task.way.empty()) line.with("way", journal::rounded(task.way));
  return line;
}

journal::Record outcome_line(const translation::Writer& writer,
                             const mission::MissionOutcome& outcome) {
  journal::Record line(writer.at, writer.node, "answer");
  line.with("uav", writer.node)
      .with("mission", outcome.mission.value())
      .with("planned", outcome.planned);
  if (!outcome.reasons.empty()) line.with("why", joined(outcome.reasons, "; "));
  if (outcome.evaluated) line.with("evaluated", true);
  if (outcome.estimate) tell_estimate(line, *outcome.estimate);
  return line;
}

journal::Record goal_line(const translation::Writer& writer, const mission::GoalStatus& goal) {
  journal::Record line(writer.at, writer.node, "goal");
  line.with("uav", writer.node)
      .with("goal", goal.id.value())
      .with("mission", goal.mission.value())
      .with("statement", goal.statement)
      .with("state", to_text(goal.state));
  if (!goal.why.empty()) line.with("why", goal.why);
  line.with("asked_by", goal.asked_by);
  if (!goal.done.empty()) line.with("done", goal.done);
  return line;
}

journal::Record decision_line(const translation::Writer& writer,
                              const mission::Decision& decision) {
  journal::Record line(writer.at, writer.node, "decision");
  line.with("uav", writer.node)
      .with("number", decision.number)
      .with("operator", decision.applied)
      .with("cause", decision.cause)
      .with("inputs", decision.inputs)
      .with("outcome", decision.outcome)
      .with("took", journal::rounded(decision.took.to_seconds()));
  return line;
}

}  // namespace skein::ddn
