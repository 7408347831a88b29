// SPDX-License-Identifier: Apache-2.0
#include "looks.hpp"

#include <algorithm>
#include <limits>

#include "mav.hpp"
#include "skein/elementary/view_of.hpp"

namespace skein::autopilot {

std::optional<std::string> Looks::refusal(const std::string& device) const {
  for (const Shot& shot : shots_) {
    if (shot.task.device == device)
      return "device '" + device + "' is in use by task " + to_text(shot.id);
  }
  return std::nullopt;
}

void Looks::start(TaskId id, elementary::TakeshotTask task, Duration now, StatusBoard& board,
                  Outbox& out) {
  const Duration until = task.duration ? now + *task.duration : Duration::max();
  const std::uint64_t left = task.shots.value_or(std::numeric_limits<std::uint64_t>::max());
  shots_.push_back({id, std::move(task), now, until, left});
  board.tell(id, TaskState::kRunning, "", out);
}

bool Looks::abort(TaskId id, const std::string& reason, StatusBoard& board, Outbox& out) {
  if (std::erase_if(shots_, [&](const Shot& shot) { return shot.id == id; }) == 0) return false;
  board.tell(id, TaskState::kAborted, reason, out);
  return true;
}

void Looks::abort_all(const std::string& reason, StatusBoard& board, Outbox& out) {
  for (const Shot& shot : shots_) board.tell(shot.id, TaskState::kAborted, reason, out);
  shots_.clear();
}

bool Looks::runs(TaskId id) const {
  return std::any_of(shots_.begin(), shots_.end(), [&](const Shot& shot) { return shot.id == id; });
}

void Looks::hear(const Commands::Outcome& outcome, const world::VehicleState& state,
                 StatusBoard& board, Outbox& out) {
  const auto shot = std::find_if(shots_.begin(), shots_.end(),
                                 [&](const Shot& one) { return one.ticket == outcome.ticket; });
  if (shot == shots_.end()) return;
  if (!outcome.accepted) {
    const TaskId id = shot->id;
    abort(id, "no picture was taken: " + outcome.why, board, out);
    return;
  }
  shot->ticket.reset();
  --shot->left;
  const world::SensorModel& sensor = *world::find_sensor(config_.model, shot->task.device);
  const world::View view = elementary::view_of(sensor, state, shot->task.target, 0);
  out.add(world::Perception{config_.uav,
                            sensor.device,
                            view.viewpoint,
                            view.direction,
                            view.range,
                            view.aperture,
                            {},
                            {}});
}

void Looks::step(std::uint8_t system, Duration now, Commands& commands, StatusBoard& board,
                 Outbox& out) {
  const auto over = [&](const Shot& shot) {
    return !shot.ticket && (shot.left == 0 || now >= shot.until);
  };
  for (Shot& shot : shots_) {
    if (shot.ticket || over(shot) || now < shot.next) continue;
    shot.ticket = commands.ask(trigger(system), now, out);
    shot.next = now + world::find_sensor(config_.model, shot.task.device)->period;
  }
  for (const Shot& shot : shots_) {
    if (over(shot)) board.tell(shot.id, TaskState::kEnded, "", out);
  }
  std::erase_if(shots_, over);
}

/// One picture.
Command Looks::trigger(std::uint8_t system) {
  mavlink::CommandLong command;
  command.target_system = system;
  command.target_component = config_.camera;
  if (config_.camera == mav::kAutopilotComponent) {
    command.command = mav::kDoDigicamControl;
    command.param5 = 1;
  } else {
    command.command = mav::kImageStartCapture;
    command.param3 = 1;
    command.param4 = static_cast<float>(++pictures_);
  }
  return command;
}

}  // namespace skein::autopilot
