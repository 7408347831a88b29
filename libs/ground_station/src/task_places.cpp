// SPDX-License-Identifier: Apache-2.0
#include "task_places.hpp"

#include <utility>

#include "request_facts.hpp"

namespace skein::ground_station {

using executive::TaskId;
using executive::TaskState;

bool TaskPlaces::is_at_ground(const SendRequest& request) const {
  if (const auto named = named_by(request.request)) {
    if (local_.knows(request.uav, *named)) return true;
    if (monitoring_.find_task(request.uav, *named)) return false;
  }
  return runs_at_ground(monitoring_.degree_of(request.uav));
}

Request TaskPlaces::adapted(const SendRequest& request, bool at_ground) const {
  return without_settled(request.request, [&](TaskId id) -> std::optional<TaskState> {
    const std::optional<TaskOnBoard> task = monitoring_.find_task(request.uav, id);
    if (!task || task->lost || !executive::is_terminal(task->state)) return {};
    const bool is_known = at_ground ? local_.knows(request.uav, id) : !task->at_ground;
    if (is_known || monitoring_.is_being_started(request.uav, id)) return {};
    return task->state;
  });
}

std::vector<Request> TaskPlaces::starting(const std::string& uav,
                                          std::vector<mission::HeldTask> tasks,
                                          FirstGiven first) const {
  TransferFacts facts;
  facts.state_of = [&](TaskId id) -> std::optional<TaskState> {
    const std::optional<TaskOnBoard> task = monitoring_.find_task(uav, id);
    if (!task || task->lost) return std::nullopt;
    return task->state;
  };
  facts.messages = monitoring_.messages_of(uav);
  return requests_to_start(std::move(tasks), facts, first);
}

}  // namespace skein::ground_station
