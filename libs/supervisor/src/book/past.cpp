// SPDX-License-Identifier: Apache-2.0
#include "book/past.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace skein::supervisor {

namespace {

/// Goals that something open waits for or has as a part, or that the executive has something of.
std::set<GoalId> needed(const Book& book) {
  std::set<GoalId> goals;
  for (const auto& [id, goal] : book.goals) {
    if (is_settled(goal.state)) continue;
    for (const auto& bound : goal.task.after) goals.insert(bound.goal);
    const std::vector<GoalId> parts = book.parts_of(id);
    goals.insert(parts.begin(), parts.end());
  }
  const auto need = [&](TaskId task) {
    const Entry* entry = book.find(task);
    if (entry != nullptr) goals.insert(entry->task.origin);
  };
  for (const auto& [id, entry] : book.tasks) {
    if (entry.over() || entry.stage() == Stage::kDropped) continue;
    goals.insert(entry.task.origin);
    for (const auto& dependence : entry.task.dependences) need(dependence.task);
    for (const auto& dependence : entry.task.stop) need(dependence.task);
  }
  return goals;
}

/// The oldest of the settled goals that are `counted`, all but the last `kept` and what is needed.
template <class Counted>
std::set<GoalId> past_of(const Book& book, std::size_t kept, const Counted& counted) {
  const auto settled = [&](GoalId id) {
    const Goal& goal = book.goals.at(id);
    return is_settled(goal.state) && counted(goal);
  };
  const auto all =
      static_cast<std::size_t>(std::count_if(book.order.begin(), book.order.end(), settled));
  std::set<GoalId> past;
  if (all <= kept + kept / 4) return past;
  std::size_t excess = all - kept;
  const std::set<GoalId> still_needed = needed(book);
  for (const GoalId id : book.order) {
    if (excess == 0) break;
    if (!settled(id)) continue;
    --excess;
    if (still_needed.count(id) == 0) past.insert(id);
  }
  return past;
}

void let_tasks_go(Book& book, const std::set<GoalId>& of) {
  if (of.empty()) return;
  std::erase_if(book.tasks, [&](const auto& one) { return of.count(one.second.task.origin) > 0; });
  for (const GoalId id : of) book.goals.at(id).tasks_gone = true;
}

/// Of goals that left the plan, the oldest: all but their numbers goes.
void let_bare_goals_go(Book& book, std::size_t kept) {
  const std::set<GoalId> planned(book.order.begin(), book.order.end());
  std::vector<std::pair<MissionTime, GoalId>> bare;
  for (const auto& [id, goal] : book.goals)
    if (planned.count(id) == 0) bare.emplace_back(goal.settled, id);
  if (bare.size() <= kept + kept / 4) return;
  std::sort(bare.begin(), bare.end());
  bare.resize(bare.size() - kept);
  const std::set<GoalId> still_needed = needed(book);
  for (const auto& [settled, id] : bare) {
    if (still_needed.count(id) > 0) continue;
    book.goals.erase(id);
    book.past.set(id.value(), 1);
  }
}

}  // namespace

void let_go_of_the_past(Book& book, Kept kept) {
  let_tasks_go(book,
               past_of(book, kept.tasks_of, [](const Goal& goal) { return !goal.tasks_gone; }));
  const std::set<GoalId> past = past_of(book, kept.goals, [](const Goal&) { return true; });
  if (past.empty()) return;
  let_tasks_go(book, past);
  std::erase_if(book.order, [&](GoalId id) { return past.count(id) > 0; });
  for (const GoalId id : past) {
    Goal& goal = book.goals.at(id);
    Goal bare;
    bare.task.id = id;
    bare.mission = goal.mission;
    bare.state = goal.state;
    bare.settled = goal.settled;
    bare.tasks_gone = true;
    goal = std::move(bare);
  }
  let_bare_goals_go(book, kept.bare);
}

}  // namespace skein::supervisor
