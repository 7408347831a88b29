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

void Vehicle::dispatch(functional::Request request) {
  if (is_own(request.id) || own_tasks_.none_open() || !holds_vehicle(request.type)) {
    return bus_.emit(ToVehicle{std::move(request)});
  }
  waiting_.push_back(std::move(request));
  own_tasks_.abort_all();
}

std::optional<functional::Status> Vehicle::interrupt(functional::TaskId task) {
  const auto waits = std::find_if(waiting_.begin(), waiting_.end(),
                                  [&](const auto& request) { return request.id == task; });
  if (waits == waiting_.end()) {
    bus_.emit(ToVehicle{{functional::Verb::kInterrupt, task}});
    return std::nullopt;
  }
  waiting_.erase(waits);
  return functional::Status{task, functional::TaskState::kAborted, "interrupted before it began"};
}

void Vehicle::release() {
  if (!own_tasks_.none_open()) return;
  for (functional::Request& request : waiting_) bus_.emit(ToVehicle{std::move(request)});
  waiting_.clear();
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
