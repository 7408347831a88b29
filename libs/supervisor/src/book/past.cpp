// SPDX-License-Identifier: Apache-2.0
#include "book/past.hpp"

#include <algorithm>
#include <set>

namespace skein::supervisor {

namespace {

/// Goals that something open waits for, or that the executive has something of.
std::set<GoalId> needed(const Book& book) {
  std::set<GoalId> goals;
  for (const auto& [id, goal] : book.goals) {
    if (is_settled(goal.state)) continue;
    for (const auto& bound : goal.task.after) goals.insert(bound.goal);
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

}  // namespace

void let_go_of_the_past(Book& book, std::size_t kept) {
  const auto settled = [&](GoalId id) { return is_settled(book.goals.at(id).state); };
  const auto all =
      static_cast<std::size_t>(std::count_if(book.order.begin(), book.order.end(), settled));
  if (all <= kept + kept / 4) return;
  std::size_t excess = all - kept;
  const std::set<GoalId> still_needed = needed(book);
  std::set<GoalId> past;
  for (const GoalId id : book.order) {
    if (excess == 0) break;
    if (!settled(id)) continue;
    --excess;
    if (still_needed.count(id) == 0) past.insert(id);
  }
  std::erase_if(book.order, [&](GoalId id) { return past.count(id) > 0; });
  std::erase_if(book.tasks,
                [&](const auto& one) { return past.count(one.second.task.origin) > 0; });
  for (const GoalId id : past) {
    Goal& goal = book.goals.at(id);
    Goal bare;
    bare.task.id = id;
    bare.mission = goal.mission;
    bare.state = goal.state;
    bare.settled = goal.settled;
    goal = std::move(bare);
  }
}

}  // namespace skein::supervisor
