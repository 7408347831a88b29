// SPDX-License-Identifier: Apache-2.0
// What others are told: decisions, states of goals, the plan.
#include <algorithm>

#include "book/wording.hpp"
#include "core.hpp"
#include "skein/foundation/rounded_seconds.hpp"

namespace skein::supervisor {

std::string joined(const std::vector<std::string>& texts) {
  std::string result;
  for (const std::string& text : texts) result += (result.empty() ? "" : "; ") + text;
  return result;
}

namespace {

mission::GoalStatus status_of(const Goal& goal) {
  return {goal.task.id,  goal.mission, mission::to_text(goal.task), goal.state, goal.why,
          goal.asked_by, goal.done};
}

mission::TaskDates dates_of(const Entry& entry) {
  if (!entry.over()) return entry.dates;
  const MissionTime over = *entry.seen.over, start = entry.seen.started.value_or(over);
  return {start, start, over, over};
}

}  // namespace

// Tasks by what they are of, goals by what they are; each goal once.
std::string Supervisor::Core::in_words(const std::string& text) const {
  const std::string tasks = with_names(text, "task", [this](std::uint64_t number) {
    const Entry* entry = book_.find(TaskId(number));
    return entry == nullptr ? std::string() : supervisor::in_words(entry->task);
  });
  std::set<std::uint64_t> told;
  return with_names(tasks, "goal", [&](std::uint64_t number) {
    const auto goal = book_.goals.find(GoalId(number));
    if (goal == book_.goals.end() || !told.insert(number).second) return std::string();
    return "goal " + std::to_string(number) + " (" + mission::to_text(goal->second.task) + ")";
  });
}

// A goal that is settled stays so; the same state is not told twice.
void Supervisor::Core::set_state(Goal& goal, GoalState state, const std::string& reason) {
  const std::string why = reason.empty() ? reason : in_words(reason);
  const bool same = goal.state == state && goal.why == why && state != GoalState::kReceived;
  if (same || is_settled(goal.state)) return;
  goal.state = state;
  goal.settled = now_;
  goal.why = why;
  out_.push_back(GoalChanged{status_of(goal)});
}

void Supervisor::Core::decide(Application application) {
  mission::Decision decision;
  decision.number = ++decisions_;
  decision.applied = std::move(application.applied);
  decision.cause = std::move(application.cause);
  decision.inputs = std::move(application.inputs);
  decision.outcome = std::move(application.outcome);
  decision.began = application.began;
  decision.took = now_ - application.began;
  out_.push_back(Decided{std::move(decision)});
}

std::string Supervisor::Core::plan_text() const {
  return "plan " + std::to_string(report_.revision + 1) + ", " +
         std::to_string(book_.open_tasks().size()) + " tasks";
}

// "ends between 352 s and 356.1 s".
std::string Supervisor::Core::extent() const {
  const std::string first = in_seconds(schedule().earliest_end);
  if (schedule().latest_end == MissionTime::max()) return "ends from " + first + " on";
  return "ends between " + first + " and " + in_seconds(schedule().latest_end);
}

void Supervisor::Core::publish() {
  mission::PlanReport report;
  const auto settled = [this](GoalId id) { return is_settled(book_.goals.at(id).state); };
  std::stable_partition(book_.order.begin(), book_.order.end(), settled);
  for (const GoalId id : book_.order) report.goals.push_back(status_of(book_.goals.at(id)));
  for (const auto& [id, entry] : book_.tasks) {
    if (!entry.live() || settled(entry.task.origin)) continue;
    report.tasks.push_back({entry.task, dates_of(entry), entry.given});
  }
  if (report.tasks == report_.tasks && report.goals == report_.goals) return;
  report.revision = report_.revision + 1;
  report.made = now_;
  report_ = report;
  out_.push_back(PlanChanged{std::move(report)});
}

}  // namespace skein::supervisor
