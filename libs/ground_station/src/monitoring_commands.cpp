// SPDX-License-Identifier: Apache-2.0
// Commands, from their issue to their one end.
#include <algorithm>
#include <functional>
#include <utility>

#include "request_facts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/ground_station/monitoring.hpp"

namespace skein::ground_station {

using executive::TaskId;
using Pending = PendingCommands::Pending;

namespace {

/// Of an answer to what is over here: what has expired may have been carried out all the same.
std::string comes_late(CommandNumber number, const std::optional<Pending>& expired,
                       CommandState state, const std::string& why) {
  const std::string command = "command " + skein::to_text(number);
  if (!expired) return command + " is not pending, yet " + std::string(to_text(state));
  const bool done = state == CommandState::kAcknowledged;
  return command + " (" + in_words(*expired) + ") had expired, and " +
         (done ? "was carried out all the same" : "was refused later: " + why);
}

}  // namespace

void Monitoring::on(const IssueCommand& input, MissionTime now, Effects& effects) {
  const CommandNumber number = commands_.issue(input);
  effects.emplace_back(CommandChanged{number, input.uav, what_of(input.request),
                                      CommandState::kIssued, "", input.asked_by});
  const auto uav = uavs_.find(input.uav);
  if (uav == uavs_.end()) {
    return close(number, CommandState::kRefused, "unknown UAV '" + input.uav + "'", effects);
  }
  uav->second.board.commands_pending += 1;
  if (input.expires <= now) {
    return close(number, CommandState::kExpired, "it had expired before it was issued", effects);
  }
  Record& record = uav->second;
  const bool waits = (record.change.under_way() || !record.waiting.empty()) && !input.ahead;
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
  const Pending* found = commands_.find(number);
  if (found == nullptr) return;
  const Pending& pending = *found;
  if (pending.expires <= now) {
    return close(number, CommandState::kExpired,
                 "it waited for a change of degree, and the plan that is handed over with it",
                 effects);
  }
  Record& record = uavs_.at(pending.uav);
  const auto problems = checks_.problems_of(pending.request, addressee(record), now);
  if (!problems.empty()) {
    return close(number, CommandState::kRefused, joined(problems, "; "), effects);
  }
  const auto* world = std::get_if<mission::ChangeWorld>(&pending.request);
  if (world != nullptr && world->place) know_place(world->place->name);
  if (const auto* change = std::get_if<mission::ChangeDegree>(&pending.request)) {
    record.change.begin(number, *change, commands_.given_up_at(pending));
  }
  effects.emplace_back(
      SendRequest{number, pending.uav, pending.request, pending.expires, pending.asked_by});
}

// The next change of degree that goes makes the others wait again.
void Monitoring::on(const ReleaseCommands& input, MissionTime now, Effects& effects) {
  Record* record = find(input.uav, "release of commands", effects);
  while (record != nullptr && !record->change.under_way() && !record->waiting.empty()) {
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
  ids.merge(commands_.started_for(input.uav));
  for (const TaskId id : ids) {
    on(IssueCommand{input.uav, executive::Abort{id}, input.expires, input.asked_by}, now, effects);
  }
}

bool Monitoring::is_being_started(const std::string& uav, TaskId task) const {
  return commands_.started_for(uav).contains(task);
}

void Monitoring::on(const RequestReplyReceived& input, MissionTime, Effects& effects) {
  const CommandState state = input.accepted ? CommandState::kAcknowledged : CommandState::kRefused;
  if (auto delivered = commands_.deliver(input.command)) {
    effects.emplace_back(std::move(*delivered));
  }
  close(input.command, state, input.why, effects);
}

// Of one that is over, the acknowledgement came after the answer: nothing new.
void Monitoring::on(const CommandDelivered& input, MissionTime, Effects& effects) {
  if (auto delivered = commands_.deliver(input.command)) {
    effects.emplace_back(std::move(*delivered));
  }
}

// One that was answered is over.
void Monitoring::on(const CommandUndelivered& input, MissionTime, Effects& effects) {
  if (commands_.find(input.command) == nullptr) return;
  close(input.command, CommandState::kExpired, "not delivered: no contact in its lifetime",
        effects);
}

void Monitoring::close(CommandNumber number, CommandState state, const std::string& why,
                       Effects& effects) {
  const std::optional<Pending> pending = commands_.take(number);
  if (!pending) {
    effects.emplace_back(Anomaly{comes_late(number, commands_.take_expired(number), state, why)});
    return;
  }
  if (state == CommandState::kExpired) commands_.remember_expired(number, *pending);
  effects.emplace_back(changed(number, *pending, state, why));
  const auto uav = uavs_.find(pending->uav);
  if (uav == uavs_.end()) return;
  Record& record = uav->second;
  record.board.commands_pending -= 1;
  const auto* mission = std::get_if<mission::UnitMission>(&pending->request);
  if (mission != nullptr && state == CommandState::kRefused) {
    const auto told = record.missions.stage(pending->uav, mission->id, MissionStage::kRefused);
    if (told) effects.emplace_back(*told);
  }
  const auto* message = std::get_if<executive::ProcessMessage>(&pending->request);
  if (message != nullptr && state == CommandState::kAcknowledged) {
    record.messages.insert(message->message);
  }
  if (record.change.ended(number, state, record.board.degree)) settle(record, effects);
}

void Monitoring::expire_due(MissionTime now, Effects& effects) {
  while (const auto late = commands_.given_up(now)) {
    close(*late, CommandState::kExpired, "no answer", effects);
  }
  for (auto& [name, record] : uavs_) {
    const auto until = record.change.until();
    if (until && *until <= now) settle(record, effects);
  }
}

// What the former life was told and did not answer; what is about a task it took with it is void.
void Monitoring::send_again(const Record& record, Effects& effects) {
  for (const auto& [number, pending] : commands_.of(record.board.name)) {
    const bool waits =
        std::find(record.waiting.begin(), record.waiting.end(), number) != record.waiting.end();
    if (waits) continue;
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
