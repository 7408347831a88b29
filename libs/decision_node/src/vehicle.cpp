// SPDX-License-Identifier: Apache-2.0
#include "vehicle.hpp"

#include <algorithm>

#include "own_tasks.hpp"
#include "skein/functional/task_types.hpp"

namespace skein::decision_node {

namespace {

bool holds_vehicle(const std::string& type) {
  return functional::TaskTypes::shipped().of(type).holds_vehicle();
}

}  // namespace

bool Vehicle::must_wait(const functional::Request& request) const {
  if (!holds_vehicle(request.type)) return false;
  return !ending_.empty() || (!is_own(request.id) && !own_tasks_.none_open());
}

void Vehicle::dispatch(functional::Request request) {
  if (!must_wait(request)) {
    if (holds_vehicle(request.type)) holding_.insert(request.id);
    return bus_.emit(ToVehicle{std::move(request)});
  }
  const bool own = is_own(request.id);
  waiting_.push_back(std::move(request));
  if (!own) own_tasks_.abort_all();
}

void Vehicle::told(const functional::Status& status) {
  if (status.state == functional::TaskState::kRunning) return;
  holding_.erase(status.id);
  ending_.erase(status.id);
}

std::optional<functional::Status> Vehicle::interrupt(functional::TaskId task) {
  const auto waits = std::find_if(waiting_.begin(), waiting_.end(),
                                  [&](const auto& request) { return request.id == task; });
  if (waits == waiting_.end()) {
    if (holding_.contains(task)) ending_.insert(task);
    bus_.emit(ToVehicle{{functional::Verb::kInterrupt, task}});
    return std::nullopt;
  }
  waiting_.erase(waits);
  return functional::Status{task, functional::TaskState::kAborted, "interrupted before it began"};
}

void Vehicle::release() {
  for (functional::Request& request : std::exchange(waiting_, {})) {
    if (must_wait(request)) {
      waiting_.push_back(std::move(request));
    } else {
      dispatch(std::move(request));
    }
  }
}

bool Vehicle::ground_has(functional::TaskId task, const std::string& type) {
  return of_ground_.insert_or_assign(task, type).second;
}

std::string Vehicle::pass_on(const functional::Status& status) {
  const auto known = of_ground_.find(status.id);
  const std::string type = known == of_ground_.end() ? "" : known->second;
  if (known != of_ground_.end() && status.state != functional::TaskState::kRunning) {
    of_ground_.erase(known);
  }
  bus_.emit(StatusPassedOn{status});
  return type;
}

}  // namespace skein::decision_node
