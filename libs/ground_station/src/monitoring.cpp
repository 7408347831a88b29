// SPDX-License-Identifier: Apache-2.0
// Status board and command intake.
#include "skein/ground_station/monitoring.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "request_facts.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::ground_station {
namespace {

using executive::TaskId;
using executive::TaskState;

// How far along a task is; the two terminal states are equally far.
int progress(TaskState state) {
  switch (state) {
    case TaskState::kScheduled:
      return 0;
    case TaskState::kStarted:
      return 1;
    case TaskState::kRunning:
      return 2;
    case TaskState::kAborting:
      return 3;
    case TaskState::kEnded:
    case TaskState::kAborted:
      break;
  }
  return 4;
}

bool moves_the_vehicle(const std::string& type) {
  constexpr std::array<std::string_view, 4> kTypes = {"takeoff", "goto", "land", "wait"};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

}  // namespace

std::string_view to_text(CommandState state) {
  switch (state) {
    case CommandState::kIssued:
      return "issued";
    case CommandState::kAcknowledged:
      return "acknowledged";
    case CommandState::kRefused:
      return "refused";
    case CommandState::kExpired:
      break;
  }
  return "expired";
}

bool is_open(const TaskOnBoard& task) { return !task.lost && !executive::is_terminal(task.state); }

const TaskOnBoard* current_task(const UavOnBoard& uav) {
  const TaskOnBoard* first = nullptr;
  for (const auto& [id, task] : uav.tasks) {
    const bool at_work = task.state == TaskState::kStarted || task.state == TaskState::kRunning;
    if (task.lost || !at_work) continue;
    if (moves_the_vehicle(task.type)) return &task;
    if (first == nullptr) first = &task;
  }
  return first;
}

Monitoring::Monitoring(const std::vector<Uav>& uavs, Duration grace) : grace_(grace) {
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
  if (deadlines_.empty()) return std::nullopt;
  return deadlines_.begin()->first;
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

const TaskOnBoard* Monitoring::find_task(const std::string& uav, TaskId task) const {
  const auto record = uavs_.find(uav);
  if (record == uavs_.end()) return nullptr;
  const auto found = record->second.board.tasks.find(task);
  return found == record->second.board.tasks.end() ? nullptr : &found->second;
}

void Monitoring::on(const Tick&, MissionTime, Effects&) {}

void Monitoring::on(const IssueCommand& input, MissionTime now, Effects& effects) {
  const CommandNumber number(++last_number_);
  pending_[number] = {input.uav, input.request, input.expires};
  effects.emplace_back(
      CommandChanged{number, input.uav, what_of(input.request), CommandState::kIssued});
  const auto uav = uavs_.find(input.uav);
  if (uav == uavs_.end()) {
    return close(number, CommandState::kRefused, "unknown UAV '" + input.uav + "'", effects);
  }
  uav->second.board.commands_pending += 1;
  deadlines_.emplace(input.expires + grace_, number);
  if (input.expires <= now) {
    return close(number, CommandState::kExpired, "it had expired before it was issued", effects);
  }
  effects.emplace_back(SendRequest{number, input.uav, input.request, input.expires});
}

// Besides the tasks on the board, those whose START is still under way.
void Monitoring::on(const AbortEverything& input, MissionTime now, Effects& effects) {
  Record* record = find(input.uav, "abort of all tasks", effects);
  if (record == nullptr) return;
  std::set<TaskId, std::greater<>> ids;
  for (const auto& [id, task] : record->board.tasks) {
    if (is_open(task) && id < executive::kFirstBackgroundId) ids.insert(id);
  }
  for (const auto& [number, pending] : pending_) {
    const std::optional<TaskId> id = started_by(pending.request);
    if (pending.uav == input.uav && id) ids.insert(*id);
  }
  for (const TaskId id : ids) {
    on(IssueCommand{input.uav, executive::Abort{id}, input.expires}, now, effects);
  }
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

void Monitoring::on(const RequestReplyReceived& input, MissionTime, Effects& effects) {
  const CommandState state = input.accepted ? CommandState::kAcknowledged : CommandState::kRefused;
  close(input.command, state, input.why, effects);
}

void Monitoring::on(const CommandUndelivered& input, MissionTime, Effects& effects) {
  close(input.command, CommandState::kExpired, "not delivered in its lifetime", effects);
}

void Monitoring::on(const PeerReachable& input, MissionTime, Effects& effects) {
  Record* record = find(input.uav, "reachability", effects);
  if (record == nullptr) return;
  record->board.reachable = input.reachable;
  if (input.restarted && !runs_at_ground(record->board.degree)) restart(*record, effects);
}

void Monitoring::on(const PlanBoardReceived& input, MissionTime now, Effects& effects) {
  Record* record = find(input.uav, "plan board", effects);
  if (record == nullptr) return;
  record->board.airborne = input.airborne;
  if (input.degree != record->board.degree) {
    record->board.degree = input.degree;
    effects.emplace_back(DegreeChanged{input.uav, input.degree});
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

void Monitoring::close(CommandNumber number, CommandState state, const std::string& why,
                       Effects& effects) {
  const auto found = pending_.find(number);
  if (found == pending_.end()) {
    effects.emplace_back(Anomaly{"command " + skein::to_text(number) + " is not pending, yet " +
                                 std::string(to_text(state))});
    return;
  }
  const Pending pending = std::move(found->second);
  pending_.erase(found);
  deadlines_.erase({pending.expires + grace_, number});
  const auto uav = uavs_.find(pending.uav);
  if (uav != uavs_.end()) uav->second.board.commands_pending -= 1;
  effects.emplace_back(CommandChanged{number, pending.uav, what_of(pending.request), state, why});
}

void Monitoring::expire_due(MissionTime now, Effects& effects) {
  while (!deadlines_.empty() && deadlines_.begin()->first <= now) {
    close(deadlines_.begin()->second, CommandState::kExpired, "no answer", effects);
  }
}

void Monitoring::learn(Record& record, const TaskEventReceived& event, MissionTime now,
                       Effects& effects) {
  const auto [entry, is_new] = record.board.tasks.try_emplace(
      event.task, TaskOnBoard{event.task, event.type, event.state, false, event.reason, now});
  TaskOnBoard& task = entry->second;
  if (task.lost) {
    // Only its first state shows that it was started anew, and is not late news of the former life.
    if (event.state != TaskState::kScheduled) return;
    record.told.erase(event.task);
    task = TaskOnBoard{event.task, event.type, event.state, false, event.reason, now};
  }
  if (!record.told[event.task].insert(event.state).second) {
    if (task.reason.empty() && task.state == event.state) task.reason = event.reason;
    return;
  }
  if (!executive::is_terminal(task.state) && progress(event.state) > progress(task.state)) {
    task.state = event.state;
    task.reason = event.reason;
    task.since = now;
  }
  effects.emplace_back(TaskChanged{record.board.name, event.task, event.state});
}

void Monitoring::restart(Record& record, Effects& effects) {
  UavRestarted restarted{record.board.name, {}};
  // The new life numbers its background routine from the beginning again.
  const auto routine = record.board.tasks.lower_bound(executive::kFirstBackgroundId);
  record.board.tasks.erase(routine, record.board.tasks.end());
  record.told.erase(record.told.lower_bound(executive::kFirstBackgroundId), record.told.end());
  for (auto& [id, task] : record.board.tasks) {
    if (!is_open(task)) continue;
    task.lost = true;
    restarted.lost.push_back(id);
  }
  effects.emplace_back(std::move(restarted));
  send_again(record, effects);
}

// What the former life was told and did not answer; what is about a task it took with it is void.
void Monitoring::send_again(const Record& record, Effects& effects) {
  std::vector<std::pair<CommandNumber, Pending>> open;
  for (const auto& [number, pending] : pending_) {
    if (pending.uav == record.board.name) open.emplace_back(number, pending);
  }
  for (const auto& [number, pending] : open) {
    const std::optional<TaskId> about = named_by(pending.request);
    const auto task = about ? record.board.tasks.find(*about) : record.board.tasks.end();
    if (task != record.board.tasks.end() && task->second.lost) {
      const std::string id = skein::to_text(*about);
      close(number, CommandState::kRefused, "the UAV restarted: task " + id + " is lost", effects);
    } else {
      effects.emplace_back(SendRequest{number, pending.uav, pending.request, pending.expires});
    }
  }
}

}  // namespace skein::ground_station
