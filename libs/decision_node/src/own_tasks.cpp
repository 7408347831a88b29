// SPDX-License-Identifier: Apache-2.0
#include "own_tasks.hpp"

#include "execution.hpp"

namespace skein::decision_node {

void OwnTasks::start(const std::string& type, functional::Parameters parameters,
                     executive::InsertionMode mode) {
  executive::Task task;
  task.id = executive::TaskId(functional::kFirstOwnId.value() + ids_.next(bus_.now()));
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
