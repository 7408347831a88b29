// SPDX-License-Identifier: Apache-2.0
#include "urgents.hpp"

#include <algorithm>

namespace skein::executive {

void Urgents::enter(TaskRecord& record, Plan::Slot slot, const std::set<TaskId>& blockers,
                    bool moves) {
  record.blockers = static_cast<std::uint32_t>(blockers.size());
  waiting_.insert(record.id);
  if (moves) to_move_.insert(record.id);
  if (blockers.empty()) return ready_.push(record.id, slot);
  for (const TaskId id : blockers) waiting_for_[id].push_back(record.id);
}

void Urgents::force(TaskRecord& record, Plan::Slot slot) {
  record.blockers = 0;
  ready_.push(record.id, slot);
}

void Urgents::over(TaskId blocker, Plan& plan) {
  const auto waiting = waiting_for_.find(blocker);
  if (waiting == waiting_for_.end()) return;
  for (const TaskId id : waiting->second) {
    const std::optional<Plan::Slot> slot = plan.find(id);
    if (!slot || !plan[*slot].urgent || plan[*slot].blockers == 0) continue;
    if (--plan[*slot].blockers == 0) ready_.push(id, *slot);
  }
  waiting_for_.erase(waiting);
}

std::vector<TaskId> Urgents::in_place_of(const TaskRecord& last, const Plan& plan) const {
  std::vector<TaskId> all;
  for (const TaskId id : waiting_) {
    const auto& used = plan[*plan.find(id)].resources;
    if (std::any_of(used.begin(), used.end(), [&](auto resource) { return last.uses(resource); }))
      all.push_back(id);
  }
  return all;
}

std::optional<Plan::Slot> Urgents::take(const Plan& plan) {
  return ready_.take(plan, [](const TaskRecord& record) {
    return record.urgent && record.state == TaskState::kScheduled && record.blockers == 0;
  });
}

void Urgents::leave(TaskRecord& record) {
  if (record.urgent) {
    waiting_.erase(record.id);
    to_move_.erase(record.id);
  }
  record.urgent = false;
}

void Urgents::let_go(TaskId task) {
  for (auto& [blocker, waiting] : waiting_for_) std::erase(waiting, task);
}

}  // namespace skein::executive
