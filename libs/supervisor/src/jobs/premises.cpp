// SPDX-License-Identifier: Apache-2.0
#include "jobs/premises.hpp"

#include <algorithm>

#include "book/progress.hpp"

namespace skein::supervisor {

namespace {

constexpr double kMovedAway = 25;  // [m] from where a plan was to begin

std::set<GoalId> goals_of(const std::set<TaskId>& tasks, const Book& book) {
  std::set<GoalId> result;
  for (const TaskId id : tasks) result.insert(book.tasks.at(id).task.origin);
  return result;
}

// Nothing new is there, and what is missing has ended well.
bool all_done(const std::vector<TaskId>& then, const std::vector<TaskId>& now, const Book& book) {
  if (!std::includes(then.begin(), then.end(), now.begin(), now.end())) return false;
  return std::all_of(then.begin(), then.end(), [&](TaskId id) {
    return std::binary_search(now.begin(), now.end(), id) || book.tasks.at(id).done();
  });
}

}  // namespace

Premises premises_of(const Book& book, const Beliefs& beliefs, const std::set<TaskId>& withdrawn) {
  Premises result;
  result.withdrawn = withdrawn;
  bool moves = !withdrawn.empty();
  for (const TaskId id : book.in_hand()) {
    if (withdrawn.count(id) != 0) continue;
    result.standing.push_back(id);
    moves = moves || holds_vehicle(book.tasks.at(id).task);
  }
  const std::set<GoalId> again = goals_of(withdrawn, book);
  for (const GoalId id : book.order) {
    if (again.count(id) != 0) result.goals.push_back(id);
  }
  for (const GoalId id : book.free_goals()) result.goals.push_back(id);
  result.world = beliefs.revision();
  result.broken = beliefs.broken();
  result.next_id = book.next_id;
  if (!moves) result.position = beliefs.vehicle().position;
  result.stays_within = kMovedAway + 2 * beliefs.model().orbit_radius;
  return result;
}

std::set<TaskId> urgently_interrupted(const Book& book) {
  std::set<GoalId> kept;
  for (const auto& [id, entry] : book.tasks) {
    const bool critical = type_of(entry.task).leaves != functional::Leaves::kAsItWas;
    const GoalId goal = entry.task.origin;
    const bool theirs = book.goals.at(goal).state == GoalState::kHandedOver;
    if (theirs || (critical && entry.under_way())) kept.insert(goal);
  }
  std::set<TaskId> result;
  for (const TaskId id : book.in_hand()) {
    if (kept.count(book.tasks.at(id).task.origin) == 0) result.insert(id);
  }
  return result;
}

std::set<TaskId> interrupted_between_parts(const Book& book) {
  const bool any = std::any_of(book.tasks.begin(), book.tasks.end(), [&](const auto& one) {
    const Entry& entry = one.second;
    return entry.under_way() && flown_along(book, entry) != nullptr;
  });
  return any ? urgently_interrupted(book) : std::set<TaskId>();
}

bool hold(const Premises& then, const Premises& now, const Book& book) {
  const auto listed = [](const std::set<TaskId>& ids) {
    return std::vector<TaskId>(ids.begin(), ids.end());
  };
  const bool moved =
      then.position && now.position && (*then.position - *now.position).norm() > then.stays_within;
  return all_done(then.standing, now.standing, book) &&
         all_done(listed(then.withdrawn), listed(now.withdrawn), book) && then.goals == now.goals &&
         then.added == now.added && then.world == now.world && then.broken == now.broken &&
         then.next_id == now.next_id && !moved;
}

}  // namespace skein::supervisor
