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
  if (is_terminal(event.state)) {
    open_.erase(event.id);
    return true;
  }
  open_.insert(event.id);
  return false;
}

}  // namespace skein::decision_node
