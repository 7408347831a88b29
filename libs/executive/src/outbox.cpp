// SPDX-License-Identifier: Apache-2.0
#include "outbox.hpp"

#include <utility>

namespace skein::executive {

void Outbox::reply(RequestKind kind, std::optional<TaskId> id,
                   const std::optional<std::string>& refusal) {
  add(Reply{kind, id, !refusal, refusal.value_or("")});
}

void Outbox::event(const TaskRecord& task) {
  if (task.joint && is_active(task.state)) joint_.insert(task.id);
  if (task.joint && !is_active(task.state)) joint_.erase(task.id);
  TaskEvent event{task.id, task.type, task.state, task.reason, task.cause};
  add(event);
  const bool another_is_joint = joint_.size() > joint_.count(task.id);
  if (another_is_joint) add(ForwardToSupervisor{std::move(event)});
}

}  // namespace skein::executive
