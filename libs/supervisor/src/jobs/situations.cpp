// SPDX-License-Identifier: Apache-2.0
#include "jobs/situations.hpp"

#include <algorithm>
#include <cmath>

#include "book/progress.hpp"
#include "safety/energy_use.hpp"
#include "watch/stand.hpp"

namespace skein::supervisor {

void move(const mission::ElementaryTask& task, Situation& at) {
  const functional::TaskType& type = type_of(task);
  if (!type.holds_vehicle()) return;
  if (type.leaves != functional::Leaves::kAsItWas)
    at.airborne = type.leaves == functional::Leaves::kInTheAir;
  if (task.way.empty()) return;
  const world::Vector3 from = task.way.size() > 1 ? task.way[task.way.size() - 2] : at.position;
  const world::Vector3 leg = task.way.back() - from;
  if (leg.head<2>().norm() > 1e-6) at.heading = std::atan2(leg.y(), leg.x());
  at.position = task.way.back();
}

namespace {

bool takes_off_or_lands(const mission::ElementaryTask& task) {
  return type_of(task).leaves != functional::Leaves::kAsItWas;
}

}  // namespace

PlanningRequest Situations::base_request(const Standing& standing,
                                         const std::set<TaskId>& withdrawn, std::uint64_t seed,
                                         MissionTime now) const {
  PlanningRequest request;
  request.knowledge = knowledge_;
  request.world = beliefs_.shared_world();
  request.situation = situation(standing, withdrawn, now);
  request.seed = seed;
  return request;
}

Situation Situations::place_after(const Standing& standing) const {
  Situation result;
  result.position = place_of_vehicle(book_, beliefs_);
  result.heading = beliefs_.vehicle().heading;
  result.airborne = beliefs_.vehicle().airborne;
  result.flies_on =
      result.airborne && !beliefs_.model().hovers && !circled(book_, beliefs_) &&
      std::none_of(standing.tasks.begin(), standing.tasks.end(), mission::holds_vehicle);
  result.stands = !result.airborne && !beliefs_.model().hovers &&
                  std::none_of(standing.tasks.begin(), standing.tasks.end(), takes_off_or_lands);
  for (const mission::ElementaryTask& task : standing.tasks) move(task, result);
  return result;
}

// A wait for orders is over when orders come, once it is under way.
Timeline Situations::timeline_after(const mission::ElementaryTask& task, MissionTime now) const {
  const Entry& entry = book_.tasks.at(task.id);
  const bool orders = task.open_ended;
  const MissionTime first = orders ? entry.dates.earliest_start : entry.dates.earliest_end;
  const MissionTime last = orders ? entry.dates.latest_start : entry.dates.latest_end;
  Timeline result;
  result.free.least = std::max(Duration(), first - now);
  result.free.most =
      last == MissionTime::max() ? Duration::max() : std::max(result.free.least, last - now);
  if (orders && entry.seen.started) result.free = {};
  const auto kind =
      ends_by_order(task) ? mission::DependenceKind::kOver : mission::DependenceKind::kEnded;
  result.after = mission::Dependence{kind, task.id};
  return result;
}

double Situations::energy_after(const Standing& standing, MissionTime now) const {
  const Retreat retreat = beliefs_.retreat(now);
  double left = beliefs_.vehicle().energy;
  for (const mission::ElementaryTask& task : standing.tasks) {
    left -= energy_to_come(book_.tasks.at(task.id), beliefs_, retreat, now);
  }
  return std::clamp(left, 0.0, 1.0);
}

// A part that stands is over when the plan begins, and has left its mapping the rest.
mission::Progress Situations::done_of(GoalId goal, const Standing& standing,
                                      MissionTime now) const {
  const std::vector<GoalId> parts = book_.parts_of(goal);
  const auto begun = [&](GoalId id) { return book_.was_begun(id); };
  mission::Progress done;
  if (begun(goal) || std::any_of(parts.begin(), parts.end(), begun))
    done = progress_of(book_, goal, now);
  for (const mission::ElementaryTask& task : standing.tasks) {
    const bool of_part = std::find(parts.begin(), parts.end(), task.origin) != parts.end();
    const Entry* lanes = of_part ? flown_along(book_, book_.tasks.at(task.id)) : nullptr;
    if (lanes == nullptr) continue;
    done.rest.reset();
    if (!lanes->beyond.empty())
      done.rest = mission::Progress::Rest{task.parameters.find("device")->text, lanes->beyond};
  }
  return done;
}

Situation Situations::situation(const Standing& standing, const std::set<TaskId>& withdrawn,
                                MissionTime now) const {
  Situation result = place_after(standing);
  result.origin = now;
  result.energy = energy_after(standing, now);
  result.broken = beliefs_.broken();
  result.next_id = book_.next_id;
  for (const auto& [id, goal] : book_.goals) {
    if (is_settled(goal.state)) continue;
    mission::Progress done = done_of(id, standing, now);
    if (!done.none()) result.done.emplace(id, std::move(done));
  }
  place_on_timelines(standing, withdrawn, result);
  return result;
}

// What was told to stop, and what others gave, is over before anything of the plan begins.
void Situations::place_loose(const std::set<TaskId>& withdrawn, Situation& result) const {
  const auto behind = [](TaskId id) {
    Timeline line;
    line.after = mission::Dependence{mission::DependenceKind::kOver, id};
    return line;
  };
  std::set<TaskId> loose = book_.loose_motion(book_.next_id);
  for (const world::SensorModel& sensor : beliefs_.model().sensors) {
    const std::set<TaskId> users = book_.loose_users_of(sensor.device);
    if (!users.empty()) result.devices[sensor.device] = behind(*users.rbegin());
  }
  for (const TaskId id : withdrawn) {
    const mission::ElementaryTask& task = book_.tasks.at(id).task;
    if (holds_vehicle(task)) loose.insert(id);
    for (const std::string& device : devices_of(task)) result.devices[device] = behind(id);
  }
  if (!loose.empty()) result.motion = behind(*loose.rbegin());
}

// Of what stands, the last that holds the vehicle, and what runs along with it; the last user of
// each device.
void Situations::place_on_timelines(const Standing& standing, const std::set<TaskId>& withdrawn,
                                    Situation& result) const {
  place_loose(withdrawn, result);
  for (const mission::ElementaryTask& task : standing.tasks) {
    if (holds_vehicle(task)) {
      result.motion = timeline_after(task, result.origin);
      result.riders.clear();
    } else {
      result.riders.push_back(timeline_after(task, result.origin));
    }
    for (const std::string& device : devices_of(task))
      result.devices[device] = timeline_after(task, result.origin);
  }
}

}  // namespace skein::supervisor
