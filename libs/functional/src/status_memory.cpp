// SPDX-License-Identifier: Apache-2.0
#include "skein/functional/status_memory.hpp"

#include "skein/foundation/contract.hpp"

namespace skein::functional {

void StatusMemory::set(const Status& status) {
  std::optional<Status>& kept = last_[status.id];
  const bool was_over = kept && is_terminal(kept->state);
  kept = status;
  if (was_over || !is_terminal(status.state)) return;
  past_.set(status.id.value(), 0);
  std::erase(over_, status.id);  // it was over before, and came again
  over_.push_back(status.id);
  if (over_.size() > kKept) let_go_of_oldest();
}

std::optional<Status> StatusMemory::last(TaskId task) const {
  SKEIN_EXPECTS(knows(task));
  if (const auto kept = last_.find(task); kept != last_.end()) return kept->second;
  return Status{task, static_cast<TaskState>(past_.of(task.value()) - 1), {}};
}

void StatusMemory::let_go_of_oldest() {
  const auto oldest = last_.find(over_.front());
  over_.pop_front();
  const bool is_over = oldest != last_.end() && is_terminal(oldest->second->state);
  if (!is_over) return;  // it came again meanwhile
  past_.set(oldest->first.value(), 1 + static_cast<std::uint8_t>(oldest->second->state));
  last_.erase(oldest);
}

}  // namespace skein::functional
