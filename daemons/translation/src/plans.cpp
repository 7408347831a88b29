// SPDX-License-Identifier: Apache-2.0
// What a UAV tells of its deliberation: goals, outcomes, decisions, plans, hand-over.
#include <algorithm>
#include <set>

#include "skein/executive/task_state.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/translation/missions.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::translation {

namespace {

// The enumerations of both sides list the same values in the same order.
static_assert(static_cast<int>(wire::GoalState::kCount) ==
              static_cast<int>(mission::GoalState::kCount));
static_assert(static_cast<int>(wire::DependenceKind::kCount) ==
              static_cast<int>(mission::DependenceKind::kCount));

constexpr std::size_t kMostWayPoints = wire::kMaximumSequence / 3;
constexpr const char* kMethodSeparator = " > ";

tl::unexpected<wire::Violation> wrong(const std::string& list, std::size_t index,
                                      const std::string& field, std::string why) {
  return tl::unexpected<wire::Violation>(
      {list + "[" + std::to_string(index) + "]." + field, std::move(why)});
}

// ---- parts of a planned task ----

std::vector<wire::TaskDependence> to_wire(const std::vector<mission::Dependence>& dependences) {
  std::vector<wire::TaskDependence> result;
  for (const mission::Dependence& one : dependences) {
    result.push_back({static_cast<wire::DependenceKind>(one.kind), one.task.value()});
  }
  return result;
}

std::vector<mission::Dependence> from_wire(const std::vector<wire::TaskDependence>& dependences) {
  std::vector<mission::Dependence> result;
  for (const wire::TaskDependence& one : dependences) {
    result.push_back({static_cast<mission::DependenceKind>(one.kind), executive::TaskId(one.task)});
  }
  return result;
}

// With more points than the wire takes: points at even steps, the first and the last among them.
std::vector<double> flat(const std::vector<world::Vector3>& way) {
  const std::size_t count = std::min(way.size(), kMostWayPoints);
  std::vector<double> numbers;
  numbers.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = count < 2 ? 0 : i * (way.size() - 1) / (count - 1);
    numbers.insert(numbers.end(), way[from].data(), way[from].data() + 3);
  }
  return numbers;
}

std::vector<world::Vector3> points_of(const std::vector<double>& numbers) {
  std::vector<world::Vector3> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return points;
}

std::vector<std::string> methods_of(const std::string& text) {
  std::vector<std::string> methods;
  const std::string separator = kMethodSeparator;
  for (std::size_t begin = 0; !text.empty() && begin != std::string::npos;) {
    const std::size_t end = text.find(separator, begin);
    methods.push_back(text.substr(begin, end - begin));
    begin = end == std::string::npos ? end : end + separator.size();
  }
  return methods;
}

// ---- planned tasks ----

wire::PlanEntry to_wire(const mission::PlannedTask& planned) {
  wire::PlanEntry entry;
  entry.id = planned.task.id.value();
  entry.type = planned.task.type;
  entry.origin = planned.task.origin.value();
  entry.dependences = to_wire(planned.task.dependences);
  entry.stop = to_wire(planned.task.stop);
  entry.earliest_start = planned.dates.earliest_start.count();
  entry.latest_start = planned.dates.latest_start.count();
  entry.earliest_end = planned.dates.earliest_end.count();
  entry.latest_end = planned.dates.latest_end.count();
  entry.committed = planned.committed;
  entry.way = flat(planned.task.way);
  entry.methods = joined(planned.task.methods, kMethodSeparator);
  return entry;
}

mission::PlannedTask from_wire(const wire::PlanEntry& entry) {
  mission::PlannedTask planned;
  planned.task.id = executive::TaskId(entry.id);
  planned.task.type = entry.type;
  planned.task.origin = mission::GoalId(entry.origin);
  planned.task.dependences = from_wire(entry.dependences);
  planned.task.stop = from_wire(entry.stop);
  planned.task.way = points_of(entry.way);
  planned.task.methods = methods_of(entry.methods);
  planned.dates = {
      MissionTime::nanoseconds(entry.earliest_start), MissionTime::nanoseconds(entry.latest_start),
      MissionTime::nanoseconds(entry.earliest_end), MissionTime::nanoseconds(entry.latest_end)};
  planned.committed = entry.committed;
  return planned;
}

wire::HeldTask to_wire(const mission::HeldTask& held) {
  return {translation::to_wire(held.task), translation::to_wire(held.state), held.in_executive,
          held.origin.value()};
}

mission::HeldTask from_wire(const wire::HeldTask& held) {
  return {translation::from_wire(held.task), translation::from_wire(held.state), held.in_executive,
          mission::GoalId(held.origin)};
}

}  // namespace

// ---- goals, outcomes, decisions ----

wire::GoalEntry to_wire(const mission::GoalStatus& goal) {
  return {goal.id.value(), goal.mission.value(),
          goal.statement,  static_cast<wire::GoalState>(goal.state),
          goal.why,        goal.asked_by,
          goal.done};
}

mission::GoalStatus from_wire(const wire::GoalEntry& goal) {
  return {mission::GoalId(goal.id),
          mission::MissionId(goal.mission),
          goal.statement,
          static_cast<mission::GoalState>(goal.state),
          goal.why,
          goal.asked_by,
          goal.done};
}

wire::MissionOutcome to_wire(const std::string& uav, const mission::MissionOutcome& outcome) {
  wire::MissionOutcome result{{}, uav, outcome.mission.value(), outcome.planned, outcome.reasons};
  result.evaluated = outcome.evaluated;
  if (!outcome.estimate) return result;
  const mission::MissionEstimate& estimate = *outcome.estimate;
  result.placement = static_cast<wire::MissionPlacement>(estimate.placement);
  result.cost = estimate.cost;
  result.energy = estimate.energy;
  result.earliest_end = estimate.earliest_end.count();
  result.latest_end = estimate.latest_end.count();
  result.plan_end = estimate.plan_end.count();
  return result;
}

mission::MissionOutcome from_wire(const wire::MissionOutcome& outcome) {
  mission::MissionOutcome result{mission::MissionId(outcome.unit_mission), outcome.planned,
                                 outcome.reasons, outcome.evaluated, std::nullopt};
  if (!outcome.evaluated || !outcome.planned) return result;
  result.estimate = {static_cast<mission::Placement>(outcome.placement),
                     outcome.cost,
                     outcome.energy,
                     MissionTime::nanoseconds(outcome.earliest_end),
                     MissionTime::nanoseconds(outcome.latest_end),
                     MissionTime::nanoseconds(outcome.plan_end)};
  return result;
}

wire::Decision to_wire(const std::string& uav, const mission::Decision& decision) {
  return {{},
          uav,
          decision.number,
          decision.applied,
          decision.cause,
          decision.inputs,
          decision.outcome,
          decision.began.count(),
          decision.took.count()};
}

mission::Decision from_wire(const wire::Decision& decision) {
  return {decision.number,
          decision.applied,
          decision.cause,
          decision.inputs,
          decision.outcome,
          MissionTime::nanoseconds(decision.began),
          Duration::nanoseconds(decision.took)};
}

// ---- hand-over ----

wire::HandOver to_wire(const std::string& uav, const mission::HandOver& hand_over) {
  wire::HandOver result;
  result.uav = uav;
  result.degree = static_cast<std::uint8_t>(hand_over.degree);
  for (const mission::HeldTask& held : hand_over.tasks) result.tasks.push_back(to_wire(held));
  for (const mission::GoalStatus& goal : hand_over.goals) result.goals.push_back(to_wire(goal));
  return result;
}

Read<mission::HandOver> from_wire(const wire::HandOver& hand_over) {
  const int degree = hand_over.degree;
  if (degree < mission::kLeastDegree || degree > mission::kGreatestDegree) {
    return tl::unexpected<wire::Violation>(
        {"degree", std::to_string(degree) + " is not a degree from 1 to 5"});
  }
  mission::HandOver result;
  result.degree = degree;
  for (std::size_t i = 0; i < hand_over.tasks.size(); ++i) {
    mission::HeldTask held = from_wire(hand_over.tasks[i]);
    if (!result.tasks.empty() && held.task.id <= result.tasks.back().task.id) {
      return wrong("tasks", i, "task.id", "not above the one before");
    }
    if (is_terminal(held.state)) return wrong("tasks", i, "state", "the task is over");
    result.tasks.push_back(std::move(held));
  }
  for (const wire::GoalEntry& goal : hand_over.goals) {
    result.goals.push_back(translation::from_wire(goal));
  }
  return result;
}

// ---- plans ----

wire::MissionPlan to_wire(const std::string& uav, const mission::PlanReport& report) {
  wire::MissionPlan plan;
  plan.uav = uav;
  plan.revision = report.revision;
  plan.made = report.made.count();
  for (const mission::PlannedTask& task : report.tasks) plan.tasks.push_back(to_wire(task));
  for (const mission::GoalStatus& goal : report.goals) plan.goals.push_back(to_wire(goal));
  return plan;
}

Read<mission::PlanReport> from_wire(const wire::MissionPlan& plan) {
  mission::PlanReport report;
  report.revision = plan.revision;
  report.made = MissionTime::nanoseconds(plan.made);
  std::set<std::uint64_t> ids;
  for (std::size_t i = 0; i < plan.tasks.size(); ++i) {
    const wire::PlanEntry& entry = plan.tasks[i];
    if (!ids.insert(entry.id).second) return wrong("tasks", i, "id", "given twice");
    if (entry.way.size() % 3 != 0) return wrong("tasks", i, "way", "not three numbers a point");
    if (entry.latest_start < entry.earliest_start) {
      return wrong("tasks", i, "latest_start", "before the earliest");
    }
    if (entry.latest_end < entry.earliest_end) {
      return wrong("tasks", i, "latest_end", "before the earliest");
    }
    report.tasks.push_back(from_wire(entry));
  }
  for (const wire::GoalEntry& goal : plan.goals) {
    report.goals.push_back(translation::from_wire(goal));
  }
  return report;
}

}  // namespace skein::translation
