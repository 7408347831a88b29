// SPDX-License-Identifier: Apache-2.0
#include "plan.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::executive {

Plan::Slot Plan::insert(Task&& task, bool background) {
  SKEIN_EXPECTS(may_insert(task.id));
  Slot slot = static_cast<Slot>(records_.size());
  if (free_.empty()) {
    records_.emplace_back();
  } else {
    slot = free_.back();
    free_.pop_back();
  }
  TaskRecord& record = records_[slot];
  record.id = task.id;
  record.type = std::move(task.type);
  record.parameters = std::move(task.parameters);
  if (task.synchronisation) {
    record.synchronisation = std::make_unique<Synchronisation>(std::move(*task.synchronisation));
  }
  record.state = TaskState::kScheduled;
  record.joint = is_joint(record.type);
  record.background = background;
  record.place_among_open = static_cast<std::uint32_t>(open_.size());
  open_.push_back(slot);
  by_id_.insert_or_assign(task.id, slot);
  slots_.insert_or_assign(task.id, slot);
  ++changes_;
  return slot;
}

bool Plan::may_insert(TaskId id) const {
  if (by_id_.contains(id)) return false;
  const std::uint8_t left = left_.of(id.value());
  return left == 0 || (left & kReadmitted) != 0;
}

void Plan::set_state(Slot slot, TaskState state) {
  TaskRecord& record = records_[slot];
  SKEIN_EXPECTS(!is_terminal(record.state));
  record.state = state;
  ++changes_;
  if (is_terminal(state)) close(slot);
}

void Plan::close(Slot slot) {
  const std::uint32_t place = records_[slot].place_among_open;
  open_[place] = open_.back();
  records_[open_[place]].place_among_open = place;
  open_.pop_back();
}

void Plan::remove(Slot slot) {
  TaskRecord& old = records_[slot];
  SKEIN_EXPECTS(is_terminal(old.state));
  slots_.erase(old.id);
  ++changes_;
  by_id_.erase(old.id);
  if (!old.background) left_.set(old.id.value(), 1 + static_cast<std::uint8_t>(old.state));
  TaskRecord blank;
  std::swap(blank.preconditions, old.preconditions);
  std::swap(blank.exit, old.exit);
  blank.state = TaskState::kAborted;
  old = std::move(blank);
  old.preconditions.clear();
  old.exit.clear();
  free_.push_back(slot);
}

std::optional<Plan::Slot> Plan::find(TaskId id) const {
  const auto found = by_id_.find(id);
  if (found == by_id_.end()) return std::nullopt;
  return found->second;
}

std::optional<TaskState> Plan::state_of(TaskId id) const {
  if (const auto slot = find(id)) return records_[*slot].state;
  const auto left = static_cast<std::uint8_t>(left_.of(id.value()) & ~kReadmitted);
  if (left == 0) return std::nullopt;
  return static_cast<TaskState>(left - 1);
}

std::vector<TaskId> Plan::open() const {
  std::vector<TaskId> ids;
  ids.reserve(open_.size());
  for (const Slot slot : open_) {
    if (!records_[slot].background) ids.push_back(records_[slot].id);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace skein::executive
