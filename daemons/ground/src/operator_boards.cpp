// SPDX-License-Identifier: Apache-2.0
#include "skein/ground/operator_boards.hpp"

#include <algorithm>
#include <utility>

#include "skein/team/ownership.hpp"
#include "skein/translation/missions.hpp"
#include "skein/translation/sensing.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::ground {

namespace {

namespace gs = ground_station;
using translation::to_wire;

static_assert(static_cast<int>(wire::CommandState::kExpired) ==
              static_cast<int>(gs::CommandState::kExpired));
static_assert(static_cast<int>(wire::AlarmState::kInfirmed) ==
              static_cast<int>(gs::AlarmState::kInfirmed));

std::int64_t instant(const std::optional<MissionTime>& at) {
  return at ? at->count() : wire::kNoInstant;
}

wire::CommandEntry entry_of(const gs::IssuedCommand& command) {
  return {command.command.value(),
          command.uav,
          command.what,
          command.asked_by,
          static_cast<wire::CommandState>(command.state),
          command.why,
          command.issued.count(),
          instant(command.settled)};
}

template <class Commands>
std::vector<wire::CommandEntry> entries_of(const Commands& commands) {
  std::vector<wire::CommandEntry> entries;
  for (const gs::IssuedCommand& one : commands) entries.push_back(entry_of(one));
  return entries;
}

wire::UavBoard board_of(const gs::UavOnBoard& uav, std::size_t held, const gs::Hand& hand,
                        std::uint32_t number) {
  wire::UavBoard board;
  board.header.instance = number;
  board.uav = uav.name;
  board.degree = static_cast<std::uint8_t>(uav.degree);
  board.reachable = uav.reachable;
  board.airborne = uav.airborne;
  board.holder = hand.holder;
  board.asker = hand.asker;
  board.passes_at = instant(hand.passes_at);
  if (uav.telemetry) {
    board.located_at = uav.telemetry_at.count();
    board.position = to_wire(uav.telemetry->position);
    board.velocity = to_wire(uav.telemetry->velocity);
    board.heading = uav.telemetry->heading;
    board.energy = uav.telemetry->energy;
  }
  board.waiting = static_cast<std::uint32_t>(uav.commands_pending);
  board.held = static_cast<std::uint32_t>(held);
  return board;
}

// All that are open, and of the others those that changed last; by id.
std::vector<wire::BoardTask> tasks_of(const gs::TaskBoard& board) {
  std::vector<const gs::TaskOnBoard*> told = board.last_over(OperatorBoards::kTasksOver);
  for (const executive::TaskId id : board.open()) told.push_back(board.kept(id));
  std::sort(told.begin(), told.end(), [](const auto* a, const auto* b) { return a->id < b->id; });
  std::vector<wire::BoardTask> tasks;
  for (const gs::TaskOnBoard* task : told) {
    tasks.push_back({task->id.value(), task->type, to_wire(task->state), task->reason,
                     task->since.count(), task->lost, task->at_ground});
  }
  return tasks;
}

wire::UavTasks tasks_board_of(const gs::UavOnBoard& uav, std::uint32_t number) {
  wire::UavTasks board;
  board.header.instance = number;
  board.uav = uav.name;
  board.tasks = tasks_of(uav.tasks);
  board.revision = uav.plan.revision;
  board.plan = to_wire(uav.name, uav.plan).tasks;
  for (const mission::GoalStatus& goal : uav.goals) board.goals.push_back(to_wire(goal));
  for (const mission::Decision& one : uav.decisions) {
    board.decisions.push_back({one.number, one.applied, one.cause, one.outcome, one.began.count()});
  }
  return board;
}

wire::BoardAlarm entry_of(const gs::Alarm& alarm) {
  return {alarm.id.value(),
          static_cast<wire::AlarmState>(alarm.state),
          to_wire(alarm.position),
          alarm.radius,
          alarm.belief,
          alarm.views,
          alarm.first_seen.count(),
          alarm.last_seen.count()};
}

wire::BoardAir entry_of(const world::Volume& volume) {
  mission::ChangeWorld change;
  change.volume = volume;
  wire::WorldChange sent = to_wire(change);
  return {sent.name, std::move(sent.corners), sent.floor, sent.ceiling, sent.from, sent.until};
}

wire::BoardTeamTask entry_of(const team::TaskStanding& standing) {
  return {standing.task.value(), standing.statement, std::string(team::to_text(standing.stage)),
          standing.owners, standing.why};
}

wire::GroundBoard ground_board_of(const gs::GroundControl& control, const gs::TeamDesk* team) {
  wire::GroundBoard board;
  board.phase = control.phase();
  board.finished = control.finished();
  board.answers = control.answers();
  for (const gs::Alarm& alarm : control.alarms()) board.alarms.push_back(entry_of(alarm));
  for (const auto& [name, volume] : control.closed_air()) board.air.push_back(entry_of(volume));
  board.commands = entries_of(control.desk().commands());
  if (team == nullptr) return board;
  for (const auto& [task, standing] : team->standings()) board.team.push_back(entry_of(standing));
  return board;
}

}  // namespace

std::optional<MissionTime> OperatorBoards::next_wakeup() const {
  if (!changed_) return std::nullopt;
  return told_at_ ? *told_at_ + kPeriod : MissionTime();
}

bool OperatorBoards::is_due(MissionTime now) const {
  const auto due = next_wakeup();
  return due && *due <= now;
}

void OperatorBoards::tell(wire::Sample board, std::vector<wire::Sample>& news) {
  const std::pair key{wire::slot_of(board), wire::header_of(board).instance};
  const auto [last, is_new] = told_.try_emplace(key, board);
  if (!is_new && last->second == board) return;
  last->second = board;
  news.push_back(std::move(board));
}

std::vector<wire::Sample> OperatorBoards::news(const gs::GroundControl& control,
                                               const gs::TeamDesk* team, const node::Roster& roster,
                                               MissionTime now) {
  const bool tasks = std::exchange(tasks_changed_, false);
  changed_ = false;
  told_at_ = now;
  missed_ = missed_ || unread_;
  if (unread_) return {};
  return changed_boards(control, team, roster, tasks);
}

std::vector<wire::Sample> OperatorBoards::be_read(const gs::GroundControl& control,
                                                  const gs::TeamDesk* team,
                                                  const node::Roster& roster) {
  unread_ = false;
  if (!std::exchange(missed_, false)) return {};
  return changed_boards(control, team, roster, true);
}

std::vector<wire::Sample> OperatorBoards::changed_boards(const gs::GroundControl& control,
                                                         const gs::TeamDesk* team,
                                                         const node::Roster& roster, bool tasks) {
  std::vector<wire::Sample> news;
  wire::GroundBoard ground = ground_board_of(control, team);
  for (const std::string& name : control.uavs()) {
    const gs::UavOnBoard& uav = control.uav(name);
    ground.uavs.push_back(name);
    const std::uint32_t number = roster.find(name)->number.value();
    tell(board_of(uav, control.held_of(name), control.desk().hand_of(name), number), news);
    if (tasks) tell(tasks_board_of(uav, number), news);
  }
  tell(std::move(ground), news);
  return news;
}

wire::OperatorReply operator_reply(const gs::OperatorAnswered& answer) {
  wire::OperatorReply reply;
  reply.who = answer.who;
  reply.number = answer.number;
  reply.accepted = answer.accepted;
  reply.complete = answer.complete;
  reply.problems = answer.problems;
  reply.commands = entries_of(answer.commands);
  return reply;
}

}  // namespace skein::ground
