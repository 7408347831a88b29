// SPDX-License-Identifier: Apache-2.0
// Dependences, stops and time constraints as conditions of the executive.
#include "skein/supervisor/commitment.hpp"

#include <algorithm>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::supervisor {

namespace {

using executive::Literal;
using executive::Modality;
using executive::TaskId;
using executive::TaskState;
using executive::TimeIs;
using mission::DependenceKind;

Literal is(TaskId task, TaskState state, Modality modality) {
  return {executive::TaskInState{task, state}, false, modality};
}

Literal precondition(const mission::Dependence& one, const std::set<TaskId>& stopped) {
  if (one.kind == DependenceKind::kRunning) {
    return is(one.task, TaskState::kRunning, Modality::kMandatory);
  }
  const bool any_end = one.kind == DependenceKind::kOver || stopped.count(one.task) > 0;
  return is(one.task, TaskState::kEnded, any_end ? Modality::kOptional : Modality::kMandatory);
}

// The modality makes a stop follow a task that is aborted too.
Literal exit_condition(const mission::Dependence& one) {
  const bool running = one.kind == DependenceKind::kRunning;
  return is(one.task, running ? TaskState::kRunning : TaskState::kEnded, Modality::kOptional);
}

/// An instant beyond all missions.
constexpr MissionTime kNever = MissionTime::nanoseconds(1'000'000'000'000'000'000);

executive::Clause held(const Hold& hold) {
  executive::Clause clause;
  if (hold.on != TaskId()) clause = {is(hold.on, TaskState::kEnded, Modality::kOptional)};
  if (hold.until != MissionTime::max()) clause.push_back(Literal{TimeIs{hold.until, true}});
  if (clause.empty()) clause.push_back(Literal{TimeIs{kNever, true}});
  return clause;
}

executive::Formula preconditions(const mission::ElementaryTask& task,
                                 const mission::TaskDates& dates, const std::set<TaskId>& stopped,
                                 const std::vector<Hold>& holds) {
  executive::Formula formula;
  for (const mission::Dependence& one : task.dependences) {
    formula.push_back({precondition(one, stopped)});
  }
  for (const Hold& hold : holds) formula.push_back(held(hold));
  const mission::TimeConstraints& time = task.time;
  if (time.start_after || time.end_after) {
    formula.push_back({Literal{TimeIs{dates.earliest_start, true}}});
  }
  const bool has_last_start = dates.latest_start != MissionTime::max();
  if ((time.start_before || time.end_before) && has_last_start) {
    // An instant counts as passed at the instant itself, at which it may still start.
    const MissionTime too_late = dates.latest_start + Duration::nanoseconds(1);
    formula.push_back({Literal{TimeIs{too_late, false}}});
  }
  return formula;
}

executive::Formula exit_conditions(const mission::ElementaryTask& task) {
  executive::Formula formula;
  for (const mission::Dependence& one : task.stop) formula.push_back({exit_condition(one)});
  if (!formula.empty() && task.time.end_after) {
    formula.push_back({Literal{TimeIs{*task.time.end_after, true}}});
  }
  return formula;
}

}  // namespace

executive::Start to_start(const mission::ElementaryTask& task, const mission::TaskDates& dates,
                          const std::set<TaskId>& stopped, const std::vector<Hold>& holds) {
  return {executive::Task{task.id, task.type, task.parameters,
                          preconditions(task, dates, stopped, holds), exit_conditions(task),
                          task.synchronisation},
          executive::InsertionMode::kSeq};
}

std::vector<executive::Input> to_requests(const std::vector<mission::ElementaryTask>& tasks,
                                          const std::map<TaskId, mission::TaskDates>& dates,
                                          std::set<TaskId> stopped, const Holds& holds) {
  std::set<TaskId> to_come;
  for (const mission::ElementaryTask& task : tasks) {
    to_come.insert(task.id);
    if (!task.stop.empty()) stopped.insert(task.id);
  }
  std::vector<executive::Input> requests, updates;
  for (const mission::ElementaryTask& task : tasks) {
    const auto found = dates.find(task.id);
    SKEIN_EXPECTS(found != dates.end());
    const auto hold = holds.find(task.id);
    const std::vector<Hold> behind = hold == holds.end() ? std::vector<Hold>() : hold->second;
    executive::Start start = to_start(task, found->second, stopped, behind);
    const auto ahead = [&](TaskId other) { return to_come.count(other) > 0; };
    if (std::any_of(behind.begin(), behind.end(), [&](const Hold& one) { return ahead(one.on); })) {
      updates.push_back(
          executive::UpdateConditions{task.id, start.task.preconditions, std::nullopt});
      start.task.preconditions = {{Literal{TimeIs{kNever, true}}}};
    }
    if (std::any_of(task.stop.begin(), task.stop.end(),
                    [&](const mission::Dependence& one) { return ahead(one.task); })) {
      updates.push_back(executive::UpdateConditions{task.id, std::nullopt, start.task.exit});
      start.task.exit.clear();
    }
    to_come.erase(task.id);
    requests.push_back(std::move(start));
  }
  requests.insert(requests.end(), updates.begin(), updates.end());
  return requests;
}

}  // namespace skein::supervisor
