// SPDX-License-Identifier: Apache-2.0
// The state that a plan starts from: when what the executive keeps is over. Source: spec 3.3.
#include <algorithm>
#include <cmath>

#include "core.hpp"

namespace skein::supervisor {

PlanningRequest Supervisor::Core::base_request(const Standing& standing,
                                               const std::set<TaskId>& withdrawn) const {
  PlanningRequest request;
  request.knowledge = config_.knowledge;
  request.world = world_;
  request.situation = situation(standing, withdrawn);
  request.seed = last_job_ + 1;
  return request;
}

// Where the last of its tasks that flies leaves it.
void Supervisor::Core::place_after(const Standing& standing, Situation& result) const {
  result.position = vehicle_.position;
  result.heading = vehicle_.heading;
  result.airborne = vehicle_.airborne;
  for (const mission::ElementaryTask& task : standing.tasks) {
    if (!uses_motion(task)) continue;
    result.airborne = task.type != "land";
    if (task.way.empty()) continue;
    const world::Vector3 from =
        task.way.size() > 1 ? task.way[task.way.size() - 2] : result.position;
    const world::Vector3 leg = task.way.back() - from;
    if (leg.head<2>().norm() > 1e-6) result.heading = std::atan2(leg.y(), leg.x());
    result.position = task.way.back();
  }
}

// A wait for orders is over when orders come, once it is under way.
Timeline Supervisor::Core::timeline_after(const mission::ElementaryTask& task) const {
  const Entry& entry = book_.tasks.at(task.id);
  const bool orders = task.open_ended;
  const MissionTime first = orders ? entry.dates.earliest_start : entry.dates.earliest_end;
  const MissionTime last = orders ? entry.dates.latest_start : entry.dates.latest_end;
  Timeline result;
  result.free.least = std::max(Duration(), first - now_);
  result.free.most =
      last == MissionTime::max() ? Duration::max() : std::max(result.free.least, last - now_);
  if (orders && entry.seen.started) result.free = {};
  const auto kind =
      ends_by_order(task) ? mission::DependenceKind::kOver : mission::DependenceKind::kEnded;
  result.after = mission::Dependence{kind, task.id};
  return result;
}

double Supervisor::Core::energy_after(const Standing& standing) const {
  double left = vehicle_.energy;
  for (const mission::ElementaryTask& task : standing.tasks) {
    left -= energy_to_come(book_.tasks.at(task.id));
  }
  return std::clamp(left, 0.0, 1.0);
}

Situation Supervisor::Core::situation(const Standing& standing,
                                      const std::set<TaskId>& withdrawn) const {
  Situation result;
  result.origin = now_;
  place_after(standing, result);
  result.energy = energy_after(standing);
  result.broken = broken_;
  result.next_id = book_.next_id;
  std::set<TaskId> loose = book_.loose_motion();
  for (const TaskId id : withdrawn) {
    if (uses_motion(book_.tasks.at(id).task)) loose.insert(id);
  }
  if (!loose.empty()) {
    result.motion.after = mission::Dependence{mission::DependenceKind::kOver, *loose.rbegin()};
  }
  for (const mission::ElementaryTask& task : standing.tasks) {
    if (uses_motion(task)) result.motion = timeline_after(task);
    const executive::Parameter* device = task.parameters.find("device");
    if (device != nullptr) result.devices[device->text] = timeline_after(task);
  }
  return result;
}

}  // namespace skein::supervisor
