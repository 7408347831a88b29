// SPDX-License-Identifier: Apache-2.0
#include "sensor_suite.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace skein::sim {

SensorSuite::SensorSuite(const world::VehicleModel& model, const std::string& uav,
                         std::uint64_t seed)
    : model_(model) {
  for (const world::SensorModel& sensor : model.sensors)
    randoms_.emplace(sensor.device, Random(seed, uav + "/sensor/" + sensor.device));
}

std::optional<std::string> SensorSuite::refusal(const std::string& device) const {
  if (broken_.count(device) > 0) return "device '" + device + "' has failed";
  for (const Shot& shot : shots_)
    if (shot.task.device == device)
      return "device '" + device + "' is in use by task " + to_text(shot.id);
  return std::nullopt;
}

void SensorSuite::start(TaskId id, TakeshotTask task, MissionTime now, StatusBoard& board,
                        std::vector<Effect>& effects) {
  Shot shot{id, std::move(task), now, MissionTime::max(),
            std::numeric_limits<std::uint64_t>::max()};
  if (shot.task.duration) shot.until = now + *shot.task.duration;
  if (shot.task.shots) shot.left = *shot.task.shots;
  shots_.push_back(std::move(shot));
  board.tell(id, TaskState::kRunning, "", now, effects);
}

bool SensorSuite::interrupt(TaskId id, MissionTime now, StatusBoard& board,
                            std::vector<Effect>& effects) {
  return abort(id, "interrupted", now, board, effects);
}

bool SensorSuite::abort(TaskId id, const std::string& reason, MissionTime now, StatusBoard& board,
                        std::vector<Effect>& effects) {
  const auto found =
      std::find_if(shots_.begin(), shots_.end(), [&](const Shot& s) { return s.id == id; });
  if (found == shots_.end()) return false;
  shots_.erase(found);
  board.tell(id, TaskState::kAborted, reason, now, effects);
  return true;
}

void SensorSuite::abort_all(const std::string& reason, MissionTime now, StatusBoard& board,
                            std::vector<Effect>& effects) {
  for (const Shot& shot : shots_) board.tell(shot.id, TaskState::kAborted, reason, now, effects);
  shots_.clear();
}

std::optional<TaskId> SensorSuite::oldest(std::optional<TaskId> but) const {
  for (const Shot& shot : shots_)
    if (but != shot.id) return shot.id;
  return std::nullopt;
}

bool SensorSuite::runs(TaskId id) const {
  return std::any_of(shots_.begin(), shots_.end(), [&](const Shot& s) { return s.id == id; });
}

void SensorSuite::break_device(const std::string& device, MissionTime now, StatusBoard& board,
                               std::vector<Effect>& effects) {
  broken_.insert(device);
  const auto found = std::find_if(shots_.begin(), shots_.end(),
                                  [&](const Shot& s) { return s.task.device == device; });
  if (found == shots_.end()) return;
  board.tell(found->id, TaskState::kAborted, "device '" + device + "' has failed", now, effects);
  shots_.erase(found);
}

void SensorSuite::step(const world::VehicleState& state, double pointing_error, const Scene& scene,
                       MissionTime now, StatusBoard& board, std::vector<Effect>& effects) {
  const auto over = [&](const Shot& shot) { return shot.left == 0 || now >= shot.until; };
  world::VehicleState eye = state;
  eye.position = world::eye_of(model_, state.position);
  for (Shot& shot : shots_) {
    const world::SensorModel& sensor = *world::find_sensor(model_, shot.task.device);
    for (; shot.next <= now && shot.next < shot.until && shot.left > 0; --shot.left) {
      const world::View view = view_of(sensor, eye, shot.task.target, pointing_error);
      effects.push_back(PerceptionOut{
          {board.uav(), sensor.device, view.viewpoint, view.direction, view.range, view.aperture,
           look(sensor, view, scene, now, randoms_.at(sensor.device)), now}});
      shot.next = shot.next + sensor.period;
    }
    if (over(shot)) board.tell(shot.id, TaskState::kEnded, "", now, effects);
  }
  shots_.erase(std::remove_if(shots_.begin(), shots_.end(), over), shots_.end());
}

std::optional<world::Vector2> SensorSuite::target() const {
  for (const Shot& shot : shots_)
    if (shot.task.target) return world::Vector2(shot.task.target->head<2>());
  return std::nullopt;
}

}  // namespace skein::sim
