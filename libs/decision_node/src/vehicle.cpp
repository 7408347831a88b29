// SPDX-License-Identifier: Apache-2.0
#include "vehicle.hpp"

#include <algorithm>

#include "merging/merging.hpp"
#include "own_tasks.hpp"
#include "skein/functional/after_loss.hpp"
#include "skein/functional/task_types.hpp"

namespace skein::decision_node {

namespace {

bool holds_vehicle(const std::string& type) {
  return functional::TaskTypes::shipped().of(type).holds_vehicle();
}

/// Both move or hold the vehicle, or use the same device: a perception holds it and uses one.
bool exclude_each_other(const functional::Request& one, const functional::Request& other) {
  if (holds_vehicle(one.type) && holds_vehicle(other.type)) return true;
  const auto* device = one.parameters.find("device");
  const auto* used = other.parameters.find("device");
  return device != nullptr && used != nullptr && device->text == used->text;
}

}  // namespace

bool Vehicle::must_wait(const functional::Request& request) const {
  if (!in_the_way(request).empty()) return true;
  return holds_vehicle(request.type) &&
         (!ending_.empty() || (!is_own(request.id) && !own_tasks_.none_open()));
}

std::vector<functional::TaskId> Vehicle::in_the_way(const functional::Request& request) const {
  std::vector<functional::TaskId> tasks;
  if (is_of_ground(request.id)) return tasks;
  for (const auto& [one, type] : of_ground_) {
    const auto found = under_way_.find(one);
    if (one == request.id || found == under_way_.end()) continue;
    if (exclude_each_other(request, found->second.request)) tasks.push_back(one);
  }
  return tasks;
}

void Vehicle::dispatch(functional::Request request) {
  if (!must_wait(request)) {
    if (!merging_.takes(request)) begin(std::move(request));
    return;
  }
  for (const functional::TaskId one : in_the_way(request))
    if (!under_way_.at(one).interrupted) stop(one);
  const bool moves = holds_vehicle(request.type), is_asked = !is_own(request.id);
  waiting_.push_back(std::move(request));
  if (moves && is_asked) own_tasks_.abort_all();
}

void Vehicle::begin(functional::Request request) {
  if (holds_vehicle(request.type)) holding_.insert(request.id);
  under_way_.insert_or_assign(request.id, UnderWay{request});
  bus_.emit(ToVehicle{std::move(request)});
}

void Vehicle::told(const functional::Status& status) {
  if (!functional::is_terminal(status.state)) return;
  holding_.erase(status.id);
  ending_.erase(status.id);
  under_way_.erase(status.id);
  std::erase_if(waiting_, [&](const auto& request) { return request.id == status.id; });
}

std::vector<functional::TaskId> Vehicle::under_way() const {
  std::vector<functional::TaskId> tasks;
  for (const auto& [task, one] : under_way_) tasks.push_back(task);
  return tasks;
}

void Vehicle::ask_again(functional::TaskId task, bool wanted) {
  const UnderWay& one = under_way_.at(task);
  const functional::TaskType& type = functional::TaskTypes::shipped().of(one.request.type);
  const bool again =
      wanted && !one.interrupted && functional::begins_anew(type) && !must_wait(one.request);
  bus_.emit(Notice{"the functional layer came back without its memory: " + one.request.type + " " +
                   std::to_string(task.value()) +
                   (again ? " is asked for again" : " is given up")});
  if (again) return bus_.emit(ToVehicle{one.request});
  stop(task);
}

void Vehicle::stop(functional::TaskId task) {
  if (holding_.contains(task)) ending_.insert(task);
  if (const auto one = under_way_.find(task); one != under_way_.end())
    one->second.interrupted = true;
  bus_.emit(ToVehicle{{functional::Verb::kInterrupt, task}});
}

std::optional<functional::Status> Vehicle::interrupt(functional::TaskId task) {
  const auto waits = std::find_if(waiting_.begin(), waiting_.end(),
                                  [&](const auto& request) { return request.id == task; });
  if (const auto portion = merging_.stop_portions(task)) {
    stop(*portion);
    return std::nullopt;
  }
  const bool waited = waits != waiting_.end() || merging_.drop(task);
  if (waits != waiting_.end()) waiting_.erase(waits);
  // What is given back while it still ends there waited for itself.
  if (!waited || under_way_.contains(task)) {
    stop(task);
    return std::nullopt;
  }
  return functional::Status{task, functional::TaskState::kAborted,
                            "interrupted while the vehicle was not at it"};
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
  if (known != of_ground_.end() && functional::is_terminal(status.state)) of_ground_.erase(known);
  bus_.emit(StatusPassedOn{status});
  return type;
}

}  // namespace skein::decision_node
