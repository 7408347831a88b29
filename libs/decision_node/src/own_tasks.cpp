// SPDX-License-Identifier: Apache-2.0
#include "own_tasks.hpp"

#include <algorithm>

#include "execution.hpp"

namespace skein::decision_node {

void OwnTasks::start(const std::string& type, functional::Parameters parameters,
                     executive::InsertionMode mode) {
  const std::int64_t milliseconds = std::max<std::int64_t>(bus_.now().count(), 0) / 1'000'000;
  next_ =
      std::max(next_, functional::kFirstOwnId.value() + static_cast<std::uint64_t>(milliseconds));
  executive::Task task;
  task.id = executive::TaskId(next_++);
  task.type = type;
  task.parameters = std::move(parameters);
  execution_.run(executive::Start{std::move(task), mode});
}

void OwnTasks::abort_all() {
  const std::set<functional::TaskId> open = open_;
  for (auto id = open.rbegin(); id != open.rend(); ++id) execution_.run(executive::Abort{*id});
}

bool OwnTasks::see(const executive::TaskEvent& event) {
  if (!is_own(event.id) || event.id >= functional::kFirstBackgroundId) return false;
  if (event.state == executive::TaskState::kStarted) under_way_.insert(event.id);
  if (event.state == executive::TaskState::kAborting) under_way_.erase(event.id);
  if (!is_terminal(event.state)) {
    open_.insert(event.id);
    return false;
  }
  open_.erase(event.id);
  const bool unasked = under_way_.erase(event.id) > 0;
  given_up_ = unasked && event.state == executive::TaskState::kAborted;
  return true;
}

}  // namespace skein::decision_node
