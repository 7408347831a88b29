// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/pending_commands.hpp"

#include "request_facts.hpp"

namespace skein::ground_station {

using executive::TaskId;

namespace {

std::optional<TaskId> task_of(const Request& request) {
  const auto* abort = std::get_if<executive::Abort>(&request);
  return abort == nullptr ? started_by(request) : std::optional(abort->id);
}

}  // namespace

std::string in_words(const PendingCommands::Pending& pending) {
  return what_of(pending.request) + ", for " + pending.uav;
}

CommandChanged changed(CommandNumber number, const PendingCommands::Pending& pending,
                       CommandState state, const std::string& why) {
  return {number, pending.uav,      what_of(pending.request), state,
          why,    pending.asked_by, task_of(pending.request)};
}

CommandNumber PendingCommands::issue(const IssueCommand& command) {
  const CommandNumber number(++last_number_);
  pending_[number] = {command.uav, command.request, command.expires, command.asked_by, false};
  deadlines_.emplace(command.expires + grace_, number);
  return number;
}

const PendingCommands::Pending* PendingCommands::find(CommandNumber number) const {
  const auto found = pending_.find(number);
  return found == pending_.end() ? nullptr : &found->second;
}

std::optional<PendingCommands::Pending> PendingCommands::take(CommandNumber number) {
  const auto found = pending_.find(number);
  if (found == pending_.end()) return std::nullopt;
  Pending pending = std::move(found->second);
  pending_.erase(found);
  deadlines_.erase({given_up_at(pending), number});
  return pending;
}

void PendingCommands::remember_expired(CommandNumber number, const Pending& pending) {
  expired_.insert_or_assign(number, pending);
  if (expired_.size() > kExpiredKept) expired_.erase(expired_.begin());
}

std::optional<PendingCommands::Pending> PendingCommands::take_expired(CommandNumber number) {
  auto found = expired_.extract(number);
  return found ? std::optional(std::move(found.mapped())) : std::nullopt;
}

std::optional<CommandChanged> PendingCommands::deliver(CommandNumber number) {
  const auto found = pending_.find(number);
  if (found == pending_.end() || std::exchange(found->second.delivered, true)) return std::nullopt;
  return changed(number, found->second, CommandState::kDelivered);
}

std::optional<CommandNumber> PendingCommands::given_up(MissionTime now) const {
  if (deadlines_.empty() || deadlines_.begin()->first > now) return std::nullopt;
  return deadlines_.begin()->second;
}

std::optional<MissionTime> PendingCommands::next_wakeup() const {
  if (deadlines_.empty()) return std::nullopt;
  return deadlines_.begin()->first;
}

std::vector<std::pair<CommandNumber, PendingCommands::Pending>> PendingCommands::of(
    const std::string& uav) const {
  std::vector<std::pair<CommandNumber, Pending>> all;
  for (const auto& [number, pending] : pending_) {
    if (pending.uav == uav) all.emplace_back(number, pending);
  }
  return all;
}

std::set<TaskId> PendingCommands::started_for(const std::string& uav) const {
  std::set<TaskId> tasks;
  for (const auto& [number, pending] : pending_) {
    const std::optional<TaskId> task = started_by(pending.request);
    if (pending.uav == uav && task) tasks.insert(*task);
  }
  return tasks;
}

std::optional<Degree> PendingCommands::last_degree_of(
    const std::deque<CommandNumber>& numbers) const {
  std::optional<Degree> degree;
  for (const CommandNumber number : numbers) {
    const Pending* pending = find(number);
    if (pending == nullptr) continue;
    const auto* change = std::get_if<mission::ChangeDegree>(&pending->request);
    if (change != nullptr) degree = change->degree;
  }
  return degree;
}

}  // namespace skein::ground_station
