// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/local_executives.hpp"

#include <utility>

#include "request_facts.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::ground_station {

using executive::TaskId;
using functional::Verb;

LocalExecutives::LocalExecutives(std::map<std::string, executive::Config> configs)
    : configs_(std::move(configs)) {}

std::vector<std::string> LocalExecutives::running() const {
  std::vector<std::string> uavs;
  for (const auto& [uav, local] : running_) uavs.push_back(uav);
  return uavs;
}

std::vector<std::string> LocalExecutives::due(MissionTime now) const {
  std::vector<std::string> uavs;
  for (const auto& [uav, local] : running_) {
    const auto wakeup = local.executive.next_wakeup();
    if (wakeup && *wakeup <= now) uavs.push_back(uav);
  }
  return uavs;
}

std::optional<MissionTime> LocalExecutives::next_wakeup() const {
  std::optional<MissionTime> wakeup;
  for (const auto& [uav, local] : running_) {
    wakeup = earliest(wakeup, local.executive.next_wakeup());
  }
  return wakeup;
}

executive::Executive& LocalExecutives::of(const std::string& uav) { return local(uav).executive; }

LocalExecutives::Local& LocalExecutives::local(const std::string& uav) {
  const auto found = running_.find(uav);
  if (found != running_.end()) return found->second;
  executive::Executive executive(configs_.at(uav));
  return running_.emplace(uav, Local{std::move(executive), std::nullopt}).first->second;
}

bool LocalExecutives::knows(const std::string& uav, TaskId task) const {
  const auto found = running_.find(uav);
  return found != running_.end() && found->second.executive.find(task).has_value();
}

bool LocalExecutives::note_flight(const std::string& uav, bool airborne) {
  std::optional<bool>& told = local(uav).airborne;
  return std::exchange(told, airborne) != airborne;
}

void LocalExecutives::note_origin(const std::string& uav, TaskId task, mission::GoalId goal) {
  local(uav).origins[task] = goal;
}

std::vector<TaskId> LocalExecutives::open_tasks_of(const std::string& uav,
                                                   mission::GoalId goal) const {
  std::vector<TaskId> tasks;
  const auto found = running_.find(uav);
  if (found == running_.end()) return tasks;
  for (const auto& [task, origin] : found->second.origins) {
    const auto view = found->second.executive.find(task);
    if (origin == goal && view && !executive::is_terminal(view->state)) tasks.push_back(task);
  }
  return tasks;
}

SendFunctional LocalExecutives::to_begin(const std::string& uav, TaskId task, MissionTime now) {
  SendFunctional send = functional_of(uav, Verb::kDispatch, task);
  if (const auto timeout = configs_.at(uav).functional_timeout) send.expires = now + *timeout;
  return send;
}

SendFunctional LocalExecutives::to_interrupt(const std::string& uav, TaskId task) {
  return functional_of(uav, Verb::kInterrupt, task);
}

std::vector<SendFunctional> LocalExecutives::under_way(const std::string& uav) {
  std::vector<SendFunctional> requests;
  for (const executive::TaskStatus& task : of(uav).tasks()) {
    if (!executive::is_active(task.state) || !is_functional(task.type)) continue;
    const bool is_aborting = task.state == executive::TaskState::kAborting;
    requests.push_back(
        functional_of(uav, is_aborting ? Verb::kInterrupt : Verb::kDispatch, task.id));
  }
  return requests;
}

SendFunctional LocalExecutives::functional_of(const std::string& uav, Verb verb, TaskId task) {
  functional::Request request{verb, task};
  if (const auto view = of(uav).find(task)) {
    request.type = view->type;
    if (verb == Verb::kDispatch) request.parameters = view->parameters;
  }
  return {uav, std::move(request)};
}

std::vector<mission::HeldTask> LocalExecutives::let_go(const std::string& uav) {
  const auto found = running_.find(uav);
  SKEIN_EXPECTS(found != running_.end());
  const executive::Executive& executive = found->second.executive;
  std::vector<mission::HeldTask> tasks;
  for (const executive::TaskStatus& status : executive.tasks()) {
    if (executive::is_terminal(status.state) || status.id >= executive::kFirstBackgroundId)
      continue;
    const executive::TaskView view = *executive.find(status.id);
    mission::HeldTask held;
    held.task = {view.id,
                 view.type,
                 view.parameters,
                 executive.preconditions(view.id),
                 executive.exit_conditions(view.id),
                 std::nullopt};
    if (view.synchronisation != nullptr) held.task.synchronisation = *view.synchronisation;
    held.state = view.state;
    held.in_executive = true;
    tasks.push_back(std::move(held));
  }
  running_.erase(found);
  return tasks;
}

}  // namespace skein::ground_station
