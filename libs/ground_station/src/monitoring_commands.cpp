// SPDX-License-Identifier: Apache-2.0
// Commands, from their issue to their one end.
#include <algorithm>
#include <functional>
#include <utility>

#include "request_facts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/ground_station/monitoring.hpp"

namespace skein::ground_station {
namespace {

using executive::TaskId;

std::optional<TaskId> task_of(const Request& request) {
  const auto* abort = std::get_if<executive::Abort>(&request);
  return abort == nullptr ? started_by(request) : std::optional(abort->id);
}

}  // namespace

void Monitoring::on(const IssueCommand& input, MissionTime now, Effects& effects) {
  const CommandNumber number(++last_number_);
  pending_[number] = {input.uav, input.request, input.expires, input.asked_by, false};
  effects.emplace_back(CommandChanged{number, input.uav, what_of(input.request),
                                      CommandState::kIssued, "", input.asked_by});
  const auto uav = uavs_.find(input.uav);
  if (uav == uavs_.end()) {
    return close(number, CommandState::kRefused, "unknown UAV '" + input.uav + "'", effects);
  }
  uav->second.board.commands_pending += 1;
  deadlines_.emplace(input.expires + grace_, number);
  if (input.expires <= now) {
    return close(number, CommandState::kExpired, "it had expired before it was issued", effects);
  }
  Record& record = uav->second;
  const bool waits = (record.change || !record.waiting.empty()) && !input.ahead;
  waits ? record.waiting.push_back(number) : send(number, now, effects);
}

void Monitoring::on(const IssueToAll& input, MissionTime now, Effects& effects) {
  for (const std::string& uav : order_) {
    on(IssueCommand{uav, input.request, input.expires, input.asked_by}, now, effects);
  }
}

Addressee Monitoring::addressee(const Record& record) const {
  Addressee to{record.board.name, record.board.degree, record.board.goals};
  for (const auto& [name, other] : uavs_) to.team[name] = {other.board.degree, other.models};
  return to;
}

std::vector<std::string> Monitoring::problems_of(const PlayRole& play, MissionTime now) const {
  const auto uav = uavs_.find(play.uav);
  if (uav == uavs_.end()) return {"unknown UAV '" + play.uav + "'"};
  std::vector<std::string> problems = checks_.problems_of(play.task, addressee(uav->second), now);
  const executive::TaskId id(play.task.id.value());
  if (uav->second.board.tasks.find(id)) {
    problems.push_back("task " + skein::to_text(id) + " of " + play.uav + " is known already");
  }
  return problems;
}

// What was accepted may turn out not to make sense only now, since it waited for the degree.
void Monitoring::send(CommandNumber number, MissionTime now, Effects& effects) {
  const auto found = pending_.find(number);
  if (found == pending_.end()) return;
  const Pending& pending = found->second;
  if (pending.expires <= now) {
    return close(number, CommandState::kExpired, "it waited for a change of degree", effects);
  }
  Record& record = uavs_.at(pending.uav);
  const auto problems = checks_.problems_of(pending.request, addressee(record), now);
  if (!problems.empty()) {
    return close(number, CommandState::kRefused, joined(problems, "; "), effects);
  }
  const auto* world = std::get_if<mission::ChangeWorld>(&pending.request);
  if (world != nullptr && world->place) know_place(world->place->name);
  if (const auto* change = std::get_if<mission::ChangeDegree>(&pending.request)) {
    record.change = Change{number, *change, pending.expires + grace_, std::nullopt};
  }
  effects.emplace_back(
      SendRequest{number, pending.uav, pending.request, pending.expires, pending.asked_by});
}

// The next change of degree that goes makes the others wait again.
void Monitoring::on(const ReleaseCommands& input, MissionTime now, Effects& effects) {
  Record* record = find(input.uav, "release of commands", effects);
  while (record != nullptr && !record->change && !record->waiting.empty()) {
    const CommandNumber number = record->waiting.front();
    record->waiting.pop_front();
    send(number, now, effects);
  }
}

// Besides the tasks on the board, those whose START is still under way.
void Monitoring::on(const AbortEverything& input, MissionTime now, Effects& effects) {
  Record* record = find(input.uav, "abort of all tasks", effects);
  if (record == nullptr) return;
  std::set<TaskId, std::greater<>> ids;
  const std::set<TaskId>& open = record->board.tasks.open();
  ids.insert(open.begin(), open.lower_bound(executive::kFirstBackgroundId));
  for (const auto& [number, pending] : pending_) {
    const std::optional<TaskId> id = started_by(pending.request);
    if (pending.uav == input.uav && id) ids.insert(*id);
  }
  for (const TaskId id : ids) {
    on(IssueCommand{input.uav, executive::Abort{id}, input.expires, input.asked_by}, now, effects);
  }
}

bool Monitoring::is_being_started(const std::string& uav, TaskId task) const {
  return std::any_of(pending_.begin(), pending_.end(), [&](const auto& entry) {
    return entry.second.uav == uav && started_by(entry.second.request) == task;
  });
}

void Monitoring::on(const RequestReplyReceived& input, MissionTime, Effects& effects) {
  const CommandState state = input.accepted ? CommandState::kAcknowledged : CommandState::kRefused;
  deliver(input.command, effects);
  close(input.command, state, input.why, effects);
}

// Of one that is over, the acknowledgement came after the answer: nothing new.
void Monitoring::on(const CommandDelivered& input, MissionTime, Effects& effects) {
  deliver(input.command, effects);
}

void Monitoring::deliver(CommandNumber number, Effects& effects) {
  const auto found = pending_.find(number);
  if (found == pending_.end() || std::exchange(found->second.delivered, true)) return;
  const Pending& pending = found->second;
  effects.emplace_back(CommandChanged{number, pending.uav, what_of(pending.request),
                                      CommandState::kDelivered, "", pending.asked_by,
                                      task_of(pending.request)});
}

// One that was answered is over.
void Monitoring::on(const CommandUndelivered& input, MissionTime, Effects& effects) {
  if (!pending_.contains(input.command)) return;
  close(input.command, CommandState::kExpired, "not delivered: no contact in its lifetime",
        effects);
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
  effects.emplace_back(CommandChanged{number, pending.uav, what_of(pending.request), state, why,
                                      pending.asked_by, task_of(pending.request)});
  if (uav == uavs_.end()) return;
  uav->second.board.commands_pending -= 1;
  const auto* mission = std::get_if<mission::UnitMission>(&pending.request);
  if (mission != nullptr && state == CommandState::kRefused) {
    tell_stage(uav->second, mission->id, MissionStage::kRefused, effects);
  }
  const auto* message = std::get_if<executive::ProcessMessage>(&pending.request);
  if (message != nullptr && state == CommandState::kAcknowledged) {
    uav->second.messages.insert(message->message);
  }
  settle_if_closed(uav->second, number, state, effects);
}

void Monitoring::expire_due(MissionTime now, Effects& effects) {
  while (!deadlines_.empty() && deadlines_.begin()->first <= now) {
    close(deadlines_.begin()->second, CommandState::kExpired, "no answer", effects);
  }
  for (auto& [name, record] : uavs_) {
    if (record.change && record.change->until <= now) settle(record, effects);
  }
}

// What the former life was told and did not answer; what is about a task it took with it is void.
void Monitoring::send_again(const Record& record, Effects& effects) {
  std::vector<std::pair<CommandNumber, Pending>> open;
  for (const auto& [number, pending] : pending_) {
    const bool waits =
        std::find(record.waiting.begin(), record.waiting.end(), number) != record.waiting.end();
    if (pending.uav == record.board.name && !waits) open.emplace_back(number, pending);
  }
  for (const auto& [number, pending] : open) {
    const std::optional<TaskId> about = named_by(pending.request);
    const auto task = about ? record.board.tasks.find(*about) : std::nullopt;
    if (task && task->lost) {
      const std::string id = skein::to_text(*about);
      close(number, CommandState::kRefused, "the UAV restarted: task " + id + " is lost", effects);
    } else {
      effects.emplace_back(
          SendRequest{number, pending.uav, pending.request, pending.expires, pending.asked_by});
    }
  }
}

}  // namespace skein::ground_station
