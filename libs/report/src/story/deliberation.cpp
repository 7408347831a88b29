// SPDX-License-Identifier: Apache-2.0
#include "story/deliberation.hpp"

#include <algorithm>

#include "story/chronology.hpp"

namespace skein::report {

namespace {

// The starts and ends of tasks, whoever ran them.
void tell_execution(const Journal& journal, std::map<TaskKey, Promise>& promises) {
  for (const TaskRecord& r : journal.tasks) {
    Promise& promise = promises[{r.uav, r.task}];
    const double t = seconds(r.stamp);
    const bool started = r.state == TaskState::kStarted || r.state == TaskState::kRunning;
    if (started && !promise.started) promise.started = t;
    if (r.state != TaskState::kEnded && r.state != TaskState::kAborted) continue;
    promise.over = t;
    promise.outcome = r.state == TaskState::kEnded ? "ended" : "aborted";
    promise.reason = r.reason;
  }
}

void tell_plans(const Journal& journal, std::map<TaskKey, Promise>& promises) {
  for (const PlannedRecord& r : journal.planned) {
    Promise& promise = promises[{r.uav, r.task}];
    const bool too_late = promise.started && seconds(r.stamp) > *promise.started;
    if (promise.planned == nullptr || !too_late) promise.planned = &r;
  }
}

std::vector<GoalStory> tell_goals(const Journal& journal) {
  std::vector<GoalStory> goals;
  std::map<TaskKey, std::size_t> places;
  for (const GoalRecord& r : journal.goals) {
    const auto [place, is_new] = places.try_emplace({r.uav, r.goal}, goals.size());
    if (is_new) goals.push_back({r.uav, &r, {}, {}});
    GoalStory& goal = goals[place->second];
    if (goal.states.empty() || goal.states.back().second != r.state) {
      goal.states.emplace_back(seconds(r.stamp), r.state);
    }
    if (!r.why.empty()) goal.why = r.why;
  }
  return goals;
}

}  // namespace

const GoalStory* Deliberation::goal(const std::string& uav, std::uint64_t id) const {
  const auto found = std::find_if(goals.begin(), goals.end(), [&](const GoalStory& g) {
    return g.uav == uav && g.first->goal == id;
  });
  return found == goals.end() ? nullptr : &*found;
}

Deliberation tell_deliberation(const Journal& journal) {
  Deliberation told;
  if (!journal.planned.empty()) {
    tell_execution(journal, told.promises);
    tell_plans(journal, told.promises);
    std::erase_if(told.promises, [](const auto& one) { return one.second.planned == nullptr; });
  }
  told.goals = tell_goals(journal);
  return told;
}

}  // namespace skein::report
