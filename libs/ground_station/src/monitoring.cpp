// SPDX-License-Identifier: Apache-2.0
// The status board of UAVs and tasks.
#include "skein/ground_station/monitoring.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"
#include "skein/functional/task_types.hpp"

namespace skein::ground_station {
namespace {

using executive::TaskId;
using executive::TaskState;

bool holds_vehicle(const std::string& type) {
  return functional::TaskTypes::shipped().of(type).holds_vehicle();
}

}  // namespace

const TaskOnBoard* current_task(const UavOnBoard& uav) {
  const TaskOnBoard* first = nullptr;
  for (const TaskId id : uav.tasks.open()) {
    const TaskOnBoard* task = uav.tasks.kept(id);
    const bool at_work = task->state == TaskState::kStarted || task->state == TaskState::kRunning;
    if (!at_work) continue;
    if (holds_vehicle(task->type)) return task;
    if (first == nullptr) first = task;
  }
  return first;
}

Monitoring::Monitoring(const std::vector<Uav>& uavs, Duration grace, MissionChecks checks)
    : commands_(grace), checks_(std::move(checks)) {
  SKEIN_EXPECTS(grace >= Duration());
  for (const Uav& uav : uavs) {
    SKEIN_EXPECTS(!uavs_.contains(uav.name));
    order_.push_back(uav.name);
    Record& record = uavs_[uav.name];
    record.board.name = uav.name;
    record.board.degree = uav.degree;
  }
}

std::vector<Monitoring::Effect> Monitoring::handle(const Input& input, MissionTime now) {
  Effects effects;
  expire_due(now, effects);
  std::visit([&](const auto& message) { on(message, now, effects); }, input);
  return effects;
}

std::optional<MissionTime> Monitoring::next_wakeup() const {
  std::optional<MissionTime> wakeup = commands_.next_wakeup();
  for (const auto& [name, record] : uavs_) wakeup = earliest(wakeup, record.change.until());
  return wakeup;
}

Board Monitoring::board(MissionTime now) const {
  Board board{now, {}};
  for (const std::string& name : order_) board.uavs.push_back(uavs_.at(name).board);
  return board;
}

Degree Monitoring::degree_of(const std::string& uav) const {
  const auto found = uavs_.find(uav);
  return found == uavs_.end() ? 3 : found->second.board.degree;
}

std::optional<TaskOnBoard> Monitoring::find_task(const std::string& uav, TaskId task) const {
  const auto record = uavs_.find(uav);
  if (record == uavs_.end()) return std::nullopt;
  return record->second.board.tasks.find(task);
}

bool Monitoring::has_told(const std::string& uav, TaskId task, TaskState state) const {
  const auto record = uavs_.find(uav);
  return record != uavs_.end() && record->second.board.tasks.has_told(task, state);
}

std::set<std::string> Monitoring::messages_of(const std::string& uav) const {
  const auto found = uavs_.find(uav);
  return found == uavs_.end() ? std::set<std::string>() : found->second.messages;
}

void Monitoring::on(const TelemetryReceived& input, MissionTime, Effects& effects) {
  Record* record = find(input.uav, "telemetry", effects);
  if (record == nullptr) return;
  if (record->board.telemetry && input.at < record->board.telemetry_at) return;  // overtaken
  record->board.telemetry = input.state;
  record->board.telemetry_at = input.at;
  record->board.airborne = input.state.airborne;
}

void Monitoring::on(const TaskEventReceived& input, MissionTime now, Effects& effects) {
  Record* record = find(input.uav, "task event", effects);
  if (record != nullptr) learn(*record, input, now, effects);
}

void Monitoring::on(const PeerReachable& input, MissionTime, Effects& effects) {
  Record* record = find(input.uav, "reachability", effects);
  if (record == nullptr) return;
  record->board.reachable = input.reachable;
  if (!input.restarted) return;
  if (!runs_at_ground(record->board.degree)) {
    record->messages.clear();
    effects.emplace_back(UavRestarted{input.uav, record->board.tasks.lose()});
  }
  record->board.plan = {};
  record->board.goals.clear();
  record->missions.restart();
  send_again(*record, effects);
  const auto change = record->change.command();
  if (change && commands_.find(*change) == nullptr) settle(*record, effects);
}

void Monitoring::on(const PlanBoardReceived& input, MissionTime now, Effects& effects) {
  Record* record = find(input.uav, "plan board", effects);
  if (record == nullptr) return;
  record->board.airborne = input.airborne;
  record->models = input.models;
  if (const auto degree = record->change.on_board(input.degree, input.at)) {
    set_degree(*record, *degree, effects);
  }
  for (const PlannedTaskStatus& task : input.tasks) {
    learn(*record, {input.uav, task.task, task.type, task.state}, now, effects);
  }
}

Monitoring::Record* Monitoring::find(const std::string& uav, const char* what, Effects& effects) {
  const auto found = uavs_.find(uav);
  if (found != uavs_.end()) return &found->second;
  effects.emplace_back(Anomaly{std::string(what) + " of unknown UAV '" + uav + "'"});
  return nullptr;
}

void Monitoring::learn(Record& record, const TaskEventReceived& event, MissionTime now,
                       Effects& effects) {
  if (record.board.tasks.learn(event, now))
    effects.emplace_back(TaskChanged{record.board.name, event.task, event.state});
}

}  // namespace skein::ground_station
