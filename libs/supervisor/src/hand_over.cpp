// SPDX-License-Identifier: Apache-2.0
// The right to decide is given up, and taken again. Source: spec 1.2, T II.1.1.
#include <algorithm>
#include <utility>

#include "core.hpp"
#include "skein/supervisor/commitment.hpp"

namespace skein::supervisor {

bool Supervisor::Core::is_wholly_given(GoalId id) const {
  const auto tasks = book_.of(id);
  return !tasks.empty() &&
         std::all_of(tasks.begin(), tasks.end(), [](const Entry* one) { return one->given; });
}

// Goals that are wholly with the executive stay under way.
void Supervisor::Core::hand_over_goal(GoalId id) {
  Goal& goal = book_.goals.at(id);
  if (is_settled(goal.state)) return;
  goal.queued = false;
  if (!is_wholly_given(id) || book_.has_lost(id)) set_state(goal, GoalState::kHandedOver);
}

void Supervisor::Core::on(const Disengage& input) {
  engaged_ = false;
  if (job_) abandon_job();
  need_.reset();
  pending_.clear();
  for (const Evaluation& one : evaluations_) {
    out_.push_back(MissionDecided{{one.mission.id, false, {input.cause}, true}});
  }
  evaluations_.clear();
  wait_again_.reset();
  if (!book_.nothing_in_hand()) stop_safe_waits();  // what the executive has waits for their end
  HandedOver held;
  const std::set<TaskId> by_order = book_.ending_by_order();
  std::vector<GoalId> goals;
  for (const GoalId id : book_.order) {
    hand_over_goal(id);
    if (book_.goals.at(id).state == GoalState::kHandedOver) goals.push_back(id);
  }
  for (const auto& [id, entry] : book_.tasks) {
    const bool open = book_.goals.at(entry.task.origin).state == GoalState::kHandedOver;
    if (!open || entry.given || !entry.live()) continue;
    executive::Task task = to_start(entry.task, entry.window, by_order).task;
    held.tasks.push_back({std::move(task), TaskState::kScheduled, false, entry.task.origin});
  }
  decide({"0 user request", input.cause, list_of("goals", goals),
          "handed over: " + std::to_string(held.tasks.size()) + " tasks", now_});
  out_.push_back(std::move(held));
}

// A goal of which the executive was given tasks meanwhile, and lost none, stays with it; what it
// was not given is no longer part of it. The others have no plan.
std::vector<GoalId> Supervisor::Core::take_back() {
  std::set<GoalId> anew;
  std::vector<GoalId> result;
  for (const GoalId id : book_.order) {
    Goal& goal = book_.goals.at(id);
    const bool partly = book_.is_given(id) && (!is_wholly_given(id) || book_.has_lost(id));
    if (is_settled(goal.state) || (goal.state != GoalState::kHandedOver && !partly)) continue;
    if (book_.has_in_hand(id) && !book_.has_lost(id)) {
      for (const Entry* entry : book_.of(id)) {
        if (!entry->given) book_.find(entry->task.id)->withdrawn = true;
      }
      const auto tasks = book_.of(id);
      const bool begun = std::any_of(tasks.begin(), tasks.end(), [](const Entry* one) {
        return one->seen.started.has_value();
      });
      set_state(goal, begun ? GoalState::kUnderWay : GoalState::kPlanned);
      continue;
    }
    anew.insert(id);
    result.push_back(id);
    set_state(goal, GoalState::kReceived);
  }
  retire(anew);
  return result;
}

// What the executive has lost to somebody else.
void Supervisor::Core::forget_but(const std::set<TaskId>& kept) {
  for (auto& [id, entry] : book_.tasks) {
    if (!entry.given || entry.over() || kept.count(id) != 0) continue;
    entry.seen.over = now_;
    entry.seen.aborted = true;
    entry.lost = true;
  }
  for (auto it = book_.loose.begin(); it != book_.loose.end();) {
    const bool there = kept.count(it->first) != 0;
    if (!there) forgotten_.insert(it->first);
    it = there ? std::next(it) : book_.loose.erase(it);
  }
}

void Supervisor::Core::on(const Engage& input) {
  const bool was_engaged = std::exchange(engaged_, true);
  told_idle_ = false;
  if (input.in_executive) forget_but({input.in_executive->begin(), input.in_executive->end()});
  if (!input.resume && !was_engaged) {
    for (const GoalId id : book_.order) hand_over_goal(id);
  }
  const std::vector<GoalId> goals = input.resume ? take_back() : std::vector<GoalId>();
  decide({"0 user request", input.cause, list_of("goals", goals), "engaged", now_});
  reschedule();
  if (!goals.empty()) need(std::nullopt, false, input.cause);
  check_air(input.cause);
}

}  // namespace skein::supervisor
