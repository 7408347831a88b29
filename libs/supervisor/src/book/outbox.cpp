// SPDX-License-Identifier: Apache-2.0
#include "book/outbox.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "book/wording.hpp"

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

std::string Outbox::in_words(const std::string& text) const {
  const std::string tasks = with_names(text, "task", [this](std::uint64_t number) {
    const Entry* entry = book_.find(TaskId(number));
    return entry == nullptr ? std::string() : supervisor::in_words(entry->task);
  });
  std::set<std::uint64_t> told;
  return with_names(tasks, "goal", [&](std::uint64_t number) {
    const GoalId id(number);
    const bool known = book_.goals.count(id) != 0 && told.insert(number).second;
    return known ? book_.named(id) : std::string();
  });
}

void Outbox::set_state(Goal& goal, GoalState state, const std::string& reason) {
  const std::string why = reason.empty() ? reason : in_words(reason);
  const bool same = goal.state == state && goal.why == why && state != GoalState::kReceived;
  if (same || is_settled(goal.state)) return;
  goal.state = state;
  goal.settled = now_;
  book_.more_settled = book_.more_settled || is_settled(state);
  goal.why = why;
  add(GoalChanged{status_of(goal)});
}

void Outbox::decide(Application application) { decide(reserve_decision(), std::move(application)); }

std::size_t Outbox::reserve_decision() {
  mission::Decision decision;
  decision.number = ++decisions_;
  add(Decided{std::move(decision)});
  return effects_.size() - 1;
}

void Outbox::decide(std::size_t place, Application application) {
  mission::Decision& decision = std::get<Decided>(effects_.at(place)).decision;
  decision.applied = std::move(application.applied);
  decision.cause = std::move(application.cause);
  decision.inputs = std::move(application.inputs);
  decision.outcome = std::move(application.outcome);
  decision.began = application.began;
  decision.took = now_ - application.began;
}

std::string Outbox::plan_text() const {
  return "plan " + std::to_string(report_.revision + 1) + ", " +
         std::to_string(book_.open_tasks().size()) + " tasks";
}

void Outbox::begin(MissionTime now) { now_ = std::max(now_, now); }

Effects Outbox::close() {
  publish();
  return std::exchange(effects_, {});
}

// What is settled is as it was told: it is not put into words again.
bool Outbox::is_as_told(const Goal& goal, const mission::GoalStatus& told) {
  const bool same = told.id == goal.task.id && told.mission == goal.mission &&
                    told.state == goal.state && told.why == goal.why &&
                    told.asked_by == goal.asked_by && told.done == goal.done;
  return same && (is_settled(goal.state) || told.statement == mission::to_text(goal.task));
}

void Outbox::publish() {
  mission::PlanReport report;
  const auto settled = [this](GoalId id) { return is_settled(book_.goals.at(id).state); };
  const std::vector<const Goal*> goals = book_.goals_settled_first();
  for (const auto& [id, entry] : book_.tasks) {
    if (!entry.live() || settled(entry.task.origin)) continue;
    report.tasks.push_back({entry.task, dates_of(entry), entry.given()});
  }
  const bool same_goals =
      std::equal(goals.begin(), goals.end(), report_.goals.begin(), report_.goals.end(),
                 [](const Goal* goal, const auto& told) { return is_as_told(*goal, told); });
  if (same_goals && report.tasks == report_.tasks) return;
  for (const Goal* goal : goals) report.goals.push_back(status_of(*goal));
  report.revision = report_.revision + 1;
  report.made = now_;
  report_ = report;
  add(PlanChanged{std::move(report)});
}

}  // namespace skein::supervisor
