// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/stand_ins.hpp"

namespace skein::ground_station {

using executive::TaskId;

void StandIns::stand_in(const std::string& uav, std::vector<mission::HeldTask>& tasks,
                        const std::function<bool(TaskId)>& is_used_up) {
  for (mission::HeldTask& held : tasks) {
    if (!is_used_up(held.task.id)) continue;
    const TaskId original = original_of(uav, held.task.id).value_or(held.task.id);
    held.task.id = TaskId(next_++);
    originals_[{uav, held.task.id}] = original;
    current_.insert_or_assign({uav, original}, held.task.id);
  }
  for (mission::HeldTask& held : tasks) {
    follow(uav, held.task.preconditions);
    follow(uav, held.task.exit);
  }
}

std::optional<TaskId> StandIns::original_of(const std::string& uav, TaskId task) const {
  const auto found = originals_.find({uav, task});
  return found == originals_.end() ? std::nullopt : std::optional(found->second);
}

TaskId StandIns::current(const std::string& uav, TaskId task) const {
  const auto found = current_.find({uav, original_of(uav, task).value_or(task)});
  return found == current_.end() ? task : found->second;
}

void StandIns::follow(const std::string& uav, executive::Formula& formula) const {
  for (executive::Clause& clause : formula) {
    for (executive::Literal& literal : clause) {
      if (auto* named = std::get_if<executive::TaskInState>(&literal.condition))
        named->task = current(uav, named->task);
    }
  }
}

Request StandIns::redirected(const std::string& uav, Request request) const {
  if (auto* abort = std::get_if<executive::Abort>(&request)) {
    abort->id = current(uav, abort->id);
  } else if (auto* start = std::get_if<executive::Start>(&request)) {
    follow(uav, start->task.preconditions);
    follow(uav, start->task.exit);
  } else if (auto* update = std::get_if<executive::UpdateConditions>(&request)) {
    update->id = current(uav, update->id);
    if (update->preconditions) follow(uav, *update->preconditions);
    if (update->exit) follow(uav, *update->exit);
  }
  return request;
}

}  // namespace skein::ground_station
