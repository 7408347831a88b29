// SPDX-License-Identifier: Apache-2.0
// Editing a plan that waits.
#include "skein/ground_station/held_plans.hpp"

#include <algorithm>

#include "request_facts.hpp"

namespace skein::ground_station {
namespace {

using executive::Clause;
using executive::Formula;
using executive::TaskId;

bool names(const executive::Literal& literal, TaskId id) {
  const auto* task = std::get_if<executive::TaskInState>(&literal.condition);
  return task != nullptr && task->task == id;
}

// A clause that can hold without the task is left that; one that cannot is replaced by what the
// task itself waited for.
void replace(Formula& formula, TaskId id, const Formula& by) {
  Formula out;
  for (Clause& clause : formula) {
    const auto rest = std::remove_if(clause.begin(), clause.end(),
                                     [&](const auto& literal) { return names(literal, id); });
    const bool named = rest != clause.end();
    clause.erase(rest, clause.end());
    if (named && clause.empty()) {
      out.insert(out.end(), by.begin(), by.end());
    } else {
      out.push_back(std::move(clause));
    }
  }
  formula = std::move(out);
}

}  // namespace

std::size_t HeldPlans::hold(const std::string& uav, const std::vector<mission::HeldTask>& tasks) {
  Plan& plan = plans_[uav];
  for (const mission::HeldTask& task : tasks) plan.insert_or_assign(task.task.id, task);
  return plan.size();
}

std::vector<mission::HeldTask> HeldPlans::of(const std::string& uav) const {
  std::vector<mission::HeldTask> out;
  const auto plan = plans_.find(uav);
  if (plan == plans_.end()) return out;
  for (const auto& [id, task] : plan->second) out.push_back(task);
  return out;
}

std::vector<mission::HeldTask> HeldPlans::take(const std::string& uav,
                                               const std::vector<TaskId>& without) {
  Plan& plan = plans_[uav];
  for (const TaskId id : without) discard(plan, id);
  std::vector<mission::HeldTask> out = of(uav);
  plan.clear();
  return out;
}

std::size_t HeldPlans::drop(const std::string& uav) {
  const std::size_t count = plans_[uav].size();
  plans_.erase(uav);
  return count;
}

std::size_t HeldPlans::drop(const std::string& uav, mission::GoalId goal) {
  std::size_t count = 0;
  for (const mission::HeldTask& task : of(uav)) {
    if (task.origin != goal) continue;
    discard(plans_[uav], task.task.id);
    ++count;
  }
  return count;
}

void HeldPlans::discard(Plan& plan, TaskId id) {
  const auto found = plan.find(id);
  if (found == plan.end()) return;
  const Formula by = std::move(found->second.task.preconditions);
  plan.erase(found);
  for (auto& [other, held] : plan) {
    replace(held.task.preconditions, id, by);
    replace(held.task.exit, id, by);
  }
}

std::optional<HeldPlans::Answer> HeldPlans::edit(const std::string& uav, const Request& request) {
  const auto plan = plans_.find(uav);
  if (plan == plans_.end()) return std::nullopt;
  const std::optional<TaskId> started = started_by(request);
  if (started && plan->second.contains(*started)) {
    return Answer{false, "id " + skein::to_text(*started) + " is that of a task held here", 0};
  }
  const std::optional<TaskId> about = named_by(request);
  const auto held = about ? plan->second.find(*about) : plan->second.end();
  if (held == plan->second.end()) return std::nullopt;
  if (const auto* update = std::get_if<executive::UpdateConditions>(&request)) {
    if (update->preconditions) held->second.task.preconditions = *update->preconditions;
    if (update->exit) held->second.task.exit = *update->exit;
    return Answer{};
  }
  discard(plan->second, *about);
  return Answer{true, "", 1};
}

}  // namespace skein::ground_station
