// SPDX-License-Identifier: Apache-2.0
#include "book/book.hpp"

#include <algorithm>

namespace skein::supervisor {

using mission::DependenceKind;

bool ends_by_order(const mission::ElementaryTask& task) {
  return task.open_ended || !task.stop.empty();
}

bool depends_on(const mission::ElementaryTask& task, TaskId other) {
  return std::any_of(task.dependences.begin(), task.dependences.end(), [&](const auto& one) {
    return one.task == other && one.kind != DependenceKind::kOver;
  });
}

Entry* Book::find(TaskId id) {
  const auto found = tasks.find(id);
  return found == tasks.end() ? nullptr : &found->second;
}

const Entry* Book::find(TaskId id) const {
  const auto found = tasks.find(id);
  return found == tasks.end() ? nullptr : &found->second;
}

std::vector<const Entry*> Book::of(GoalId goal) const {
  std::vector<const Entry*> result;
  for (const auto& [id, entry] : tasks) {
    if (entry.task.origin == goal && entry.live()) result.push_back(&entry);
  }
  return result;
}

bool Book::has_in_hand(GoalId goal) const {
  const auto all = of(goal);
  return std::any_of(all.begin(), all.end(), [](const Entry* one) { return one->in_hand(); });
}

bool Book::is_wholly_given(GoalId goal) const {
  const auto all = of(goal);
  return !all.empty() &&
         std::all_of(all.begin(), all.end(), [](const Entry* one) { return one->given(); });
}

bool Book::is_given(GoalId goal) const {
  return std::any_of(tasks.begin(), tasks.end(), [goal](const auto& one) {
    return one.second.task.origin == goal && one.second.live() && one.second.given();
  });
}

bool Book::was_begun(GoalId goal) const {
  return std::any_of(tasks.begin(), tasks.end(), [&](const auto& one) {
    return one.second.task.origin == goal && one.second.seen.started.has_value();
  });
}

bool Book::has_lost(GoalId goal) const {
  const auto all = of(goal);
  return std::any_of(all.begin(), all.end(),
                     [](const Entry* one) { return one->over() && !one->done(); });
}

bool Book::is_planned(GoalId goal) const {
  bool any = false;
  for (const auto& [id, entry] : tasks) {
    if (entry.task.origin != goal || !entry.live()) continue;
    if (entry.given()) return false;
    any = true;
  }
  return any;
}

std::vector<TaskId> Book::in_hand() const {
  std::vector<TaskId> result;
  for (const auto& [id, entry] : tasks) {
    if (entry.in_hand()) result.push_back(id);
  }
  return result;
}

bool Book::nothing_in_hand() const {
  return std::none_of(tasks.begin(), tasks.end(),
                      [](const auto& one) { return one.second.in_hand(); });
}

Standing Book::standing(const std::set<TaskId>& but) const {
  Standing result;
  for (const TaskId id : in_hand()) {
    if (but.count(id) != 0) continue;
    const Entry& entry = tasks.at(id);
    result.tasks.push_back(entry.task);
    result.seen[id] = entry.seen;
  }
  result.bounds = bounds();
  // What is repaired is not repaired for what others only may do.
  result.bounds.meetings.reliance = std::max(meetings.reliance, Meetings::Reliance::kOnTheirBest);
  return result;
}

bool Book::counts(const Entry& entry) const {
  if (!entry.live() || entry.over()) return false;
  return entry.given() || goals.at(entry.task.origin).open();
}

std::vector<mission::ElementaryTask> Book::open_tasks() const {
  std::vector<mission::ElementaryTask> result;
  for (const auto& [id, entry] : tasks) {
    if (counts(entry)) result.push_back(entry.task);
  }
  return result;
}

std::vector<GoalId> Book::free_goals() const {
  std::vector<GoalId> result;
  bool given_behind = false;
  for (auto id = order.rbegin(); id != order.rend(); ++id) {
    const Goal& goal = goals.at(*id);
    if (!goal.open()) continue;
    const bool given = is_given(*id);
    const bool passed = goal.true_at && given_behind;
    given_behind = given_behind || given;
    if (!goal.queued && !given && !passed) result.push_back(*id);
  }
  std::reverse(result.begin(), result.end());
  return result;
}

GoalBounds Book::bounds(const std::vector<mission::HighLevelTask>& more) const {
  GoalBounds result;
  const auto add = [&](const mission::HighLevelTask& task) {
    if (task.after.empty()) return;
    result.of[task.id] = task.after;
    for (const mission::GoalBound& one : task.after) {
      const auto other = goals.find(one.goal);
      if (other != goals.end() && other->second.state == GoalState::kAchieved)
        result.over[one.goal] = other->second.settled;
    }
  };
  for (const auto& [id, goal] : goals) {
    if (!is_settled(goal.state)) add(goal.task);
  }
  for (const mission::HighLevelTask& task : more) add(task);
  result.meetings = meetings;
  return result;
}

std::vector<mission::HighLevelTask> Book::tasks_of(const std::vector<GoalId>& ids) const {
  std::vector<mission::HighLevelTask> result;
  for (const GoalId id : ids) result.push_back(goals.at(id).task);
  return result;
}

std::set<TaskId> Book::ending_by_order() const {
  std::set<TaskId> result;
  for (const auto& [id, entry] : tasks) {
    if (ends_by_order(entry.task)) result.insert(id);
  }
  return result;
}

std::set<GoalId> Book::falling_with(std::set<GoalId> falling) const {
  const auto is_lost = [&](const Entry& entry, const mission::Dependence& on) {
    const Entry* other = find(on.task);
    return depends_on(entry.task, on.task) && other != nullptr && !other->done() &&
           (falling.count(other->task.origin) != 0 || other->over());
  };
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& [id, entry] : tasks) {
      if (!entry.in_hand() || falling.count(entry.task.origin) != 0) continue;
      const auto& on = entry.task.dependences;
      if (std::any_of(on.begin(), on.end(), [&](const auto& d) { return is_lost(entry, d); })) {
        grew = falling.insert(entry.task.origin).second;
      }
    }
  }
  return falling;
}

// A wait for orders is no wait of what comes before it: each would wait for the other for ever.
std::set<TaskId> Book::loose_motion(TaskId next) const {
  std::set<TaskId> result;
  for (const auto& [id, one] : loose) {
    if (one.holds_vehicle && !one.gives_way) result.insert(id);
  }
  for (const auto& [id, entry] : tasks) {
    if (!entry.given() || entry.over() || !holds_vehicle(entry.task)) continue;
    const bool waits = entry.task.open_ended && id < next;
    if (!entry.live() || entry.by_others || waits) result.insert(id);
  }
  return result;
}

bool Book::is_led_away() const {
  return std::any_of(loose.begin(), loose.end(),
                     [](const auto& one) { return one.second.leads_away; });
}

std::set<TaskId> Book::loose_users_of(const std::string& device) const {
  std::set<TaskId> result;
  for (const auto& [id, entry] : tasks) {
    if (!entry.given() || entry.over() || !(!entry.live() || entry.by_others)) continue;
    const auto devices = devices_of(entry.task);
    if (std::find(devices.begin(), devices.end(), device) != devices.end()) result.insert(id);
  }
  return result;
}

std::vector<const Entry*> Book::waits_for_orders() const {
  std::vector<const Entry*> result;
  for (const auto& [id, entry] : tasks) {
    if (entry.in_hand() && entry.task.open_ended && !entry.ordered()) result.push_back(&entry);
  }
  return result;
}

// The executive starts it in the step that it is now telling of. What was stopped never counts as
// ended there, so it is enough that it is over.
bool Book::is_due(const Entry& entry) const {
  const auto& waits = entry.task.dependences;
  return std::all_of(waits.begin(), waits.end(), [&](const mission::Dependence& wait) {
    const Entry* other = find(wait.task);
    if (other == nullptr) return true;
    const bool over = other->over();
    if (wait.kind == mission::DependenceKind::kRunning) return other->under_way();
    const bool any_end = wait.kind == mission::DependenceKind::kOver || ends_by_order(other->task);
    return over && (any_end || !other->seen.aborted);
  });
}

// Of what others gave nobody here knows when it begins.
bool Book::has_occupation(MissionTime soon) const {
  const bool occupied = std::any_of(tasks.begin(), tasks.end(), [&](const auto& one) {
    const Entry& entry = one.second;
    const bool goes_on = entry.given() && !entry.over() && !entry.stopping();
    if (!goes_on || entry.seen.started) return goes_on;
    const bool begins = entry.by_others || entry.dates.earliest_start <= soon;
    return begins && (holds_vehicle(entry.task) || is_due(entry));
  });
  return occupied || std::any_of(loose.begin(), loose.end(), [](const auto& one) {
           return one.second.holds_vehicle && !one.second.stopping;
         });
}

std::optional<TaskId> Book::in_the_way() const {
  const auto busy = [](const auto& one) {
    const Entry& entry = one.second;
    return entry.given() && entry.seen.started && !entry.over() && holds_vehicle(entry.task);
  };
  const auto goes_on = [](const auto& one) {
    return one.second.holds_vehicle && (one.second.ours || one.second.begun);
  };
  if (std::any_of(tasks.begin(), tasks.end(), busy)) return std::nullopt;
  if (std::any_of(loose.begin(), loose.end(), goes_on)) return std::nullopt;
  const auto first = std::find_if(loose.begin(), loose.end(),
                                  [](const auto& one) { return one.second.holds_vehicle; });
  const bool waits = std::any_of(tasks.begin(), tasks.end(), [&](const auto& one) {
    const Entry& entry = one.second;
    const bool held = entry.given() ? is_due(entry) : is_led_away();
    return !entry.over() && !entry.seen.started && held;
  });
  return first != loose.end() && waits ? std::optional(first->first) : std::nullopt;
}

bool Book::stops_landing() const {
  return std::any_of(tasks.begin(), tasks.end(), [](const auto& one) {
    const Entry& entry = one.second;
    return entry.seen.started && !entry.over() && entry.stopping() &&
           mission::type_of(entry.task).leaves == functional::Leaves::kOnTheGround;
  });
}

bool Book::waits_safely() const {
  return std::any_of(loose.begin(), loose.end(), [](const auto& one) {
    return one.second.ours && one.second.type == "wait" && !one.second.stopping;
  });
}

std::string Book::named(GoalId goal) const {
  const auto found = goals.find(goal);
  const std::string what =
      found == goals.end() ? "" : " (" + mission::to_text(found->second.task) + ")";
  return "goal " + to_text(goal) + what;
}

TaskId Book::add_loose(const std::string& type) {
  const TaskId id = next_id;
  next_id = TaskId(id.value() + 1);
  loose[id] = {.type = type, .ours = true, .holds_vehicle = true};
  return id;
}

namespace {

using mission::Dependence;

/// Of the plan's tasks, those whose end stops that one of the goal.
std::vector<Dependence> ends_that_stop(const mission::ElementaryPlan& plan, GoalId goal,
                                       TaskId task) {
  const auto found = std::find_if(plan.tasks.begin(), plan.tasks.end(), [&](const auto& one) {
    return one.id == task && one.origin == goal;
  });
  std::vector<Dependence> result;
  if (found == plan.tasks.end()) return result;
  for (const Dependence& one : found->stop)
    if (one.kind == DependenceKind::kEnded) result.push_back(one);
  return result;
}

}  // namespace

// Any end counts of what others stop, since that is an abort; so what waits for it in its goal
// waits for what stops it too, else it would begin after a failure as well.
void Book::enter(const mission::ElementaryPlan& plan) {
  for (const mission::ElementaryTask& task : plan.tasks) {
    Entry entry;
    entry.task = task;
    std::vector<Dependence>& all = entry.task.dependences;
    for (const Dependence& one : task.dependences) {
      if (one.kind != DependenceKind::kEnded) continue;
      for (const Dependence& stop : ends_that_stop(plan, task.origin, one.task))
        if (stop.task < task.id && std::find(all.begin(), all.end(), stop) == all.end())
          all.push_back(stop);
    }
    next_id = std::max(next_id, TaskId(task.id.value() + 1));
    tasks[task.id] = std::move(entry);
  }
}

std::vector<TaskId> Book::withdraw(const std::set<GoalId>& from) {
  std::vector<TaskId> result;
  for (auto it = tasks.rbegin(); it != tasks.rend(); ++it) {
    Entry& entry = it->second;
    if (from.count(entry.task.origin) == 0 || !entry.live()) continue;
    if (entry.in_hand()) result.push_back(it->first);
    entry.advance(Step::kWithdraw);
  }
  return result;
}

std::vector<const Goal*> Book::goals_settled_first() {
  std::vector<const Goal*> all;
  all.reserve(order.size());
  for (const GoalId id : order) all.push_back(&goals.at(id));
  const auto settled = [](const Goal* goal) { return is_settled(goal->state); };
  if (std::is_partitioned(all.begin(), all.end(), settled)) return all;
  std::stable_partition(all.begin(), all.end(), settled);
  std::transform(all.begin(), all.end(), order.begin(),
                 [](const Goal* goal) { return goal->task.id; });
  return all;
}

void Book::reorder(const std::vector<GoalId>& wanted) {
  const auto is_wanted = [&](GoalId id) {
    return std::find(wanted.begin(), wanted.end(), id) != wanted.end();
  };
  std::vector<GoalId> first, last;
  for (const GoalId id : order) {
    if (is_wanted(id)) continue;
    const Goal& goal = goals.at(id);
    const bool before = is_settled(goal.state) || is_given(id) || goal.true_at;
    (before ? first : last).push_back(id);
  }
  std::stable_partition(first.begin(), first.end(),
                        [&](GoalId id) { return is_settled(goals.at(id).state); });
  order = std::move(first);
  order.insert(order.end(), wanted.begin(), wanted.end());
  order.insert(order.end(), last.begin(), last.end());
}

}  // namespace skein::supervisor
