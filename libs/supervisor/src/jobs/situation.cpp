// SPDX-License-Identifier: Apache-2.0
// The state that a plan starts from: when what the executive keeps is over. Source: spec 3.3.
#include <algorithm>
#include <cmath>

#include "book/progress.hpp"
#include "core.hpp"
#include "flight/flight_times.hpp"

namespace skein::supervisor {

namespace {

/// A goal without tasks is true as near as this to where the plan has it [m]; no nearer than a plan
/// may begin away from where it was made for.
constexpr double kThere = 25;

// What a task does to where the vehicle is. One that does not end in the air or on the ground by
// itself leaves it there where it was: a wait on the ground is no flight.
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

}  // namespace

PlanningRequest Supervisor::Core::base_request(const Standing& standing,
                                               const std::set<TaskId>& withdrawn) const {
  PlanningRequest request;
  request.knowledge = config_.knowledge;
  request.world = world_;
  request.situation = situation(standing, withdrawn);
  request.seed = last_job_ + 1;
  return request;
}

// Where the last of its tasks that moves it leaves it.
void Supervisor::Core::place_after(const Standing& standing, Situation& result) const {
  result.position = place();
  result.heading = vehicle_.heading;
  result.airborne = vehicle_.airborne;
  for (const mission::ElementaryTask& task : standing.tasks) move(task, result);
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
  for (const auto& [id, goal] : book_.goals) {
    if (is_settled(goal.state) || !book_.was_begun(id)) continue;
    mission::Progress done = progress_of(book_, id, now_);
    if (!done.none()) result.done.emplace(id, std::move(done));
  }
  place_on_timelines(standing, withdrawn, result);
  return result;
}

// What was told to stop, and what others gave, is over before anything of the plan begins.
void Supervisor::Core::place_loose(const std::set<TaskId>& withdrawn, Situation& result) const {
  const auto behind = [](TaskId id) {
    Timeline line;
    line.after = mission::Dependence{mission::DependenceKind::kOver, id};
    return line;
  };
  std::set<TaskId> loose = book_.loose_motion(book_.next_id);
  for (const world::SensorModel& sensor : config_.knowledge->vehicle.sensors) {
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
void Supervisor::Core::place_on_timelines(const Standing& standing,
                                          const std::set<TaskId>& withdrawn,
                                          Situation& result) const {
  place_loose(withdrawn, result);
  for (const mission::ElementaryTask& task : standing.tasks) {
    if (holds_vehicle(task)) {
      result.motion = timeline_after(task);
      result.riders.clear();
    } else {
      result.riders.push_back(timeline_after(task));
    }
    for (const std::string& device : devices_of(task))
      result.devices[device] = timeline_after(task);
  }
}

// ---- goals without tasks ----

// Of each free goal that the plan gives no tasks: where the vehicle is when its turn comes.
void Supervisor::Core::foresee_true_goals() {
  Situation at;
  place_after(book_.standing(), at);
  for (const GoalId id : book_.free_goals()) {
    Goal& goal = book_.goals.at(id);
    goal.true_at.reset();
    const auto tasks = book_.of(id);
    for (const Entry* entry : tasks) move(entry->task, at);
    if (tasks.empty()) goal.true_at = Whereabouts{at.position, at.airborne};
  }
}

bool Supervisor::Core::is_there(const Whereabouts& expected) const {
  const world::VehicleModel& vehicle = config_.knowledge->vehicle;
  const double wavers =
      2 + arrival_distance(vehicle, world_->wind) + (vehicle.hovers ? 0 : vehicle.orbit_radius);
  return vehicle_.airborne == expected.airborne &&
         (vehicle_.position - expected.position).norm() <= std::max(kThere, wavers);
}

// Its turn comes when all before it is settled: then it is achieved if it is true, else it needs
// tasks after all. What is counted from its end has its dates from then on.
void Supervisor::Core::settle_true_goals() {
  if (repairing()) return;
  for (const GoalId id : std::vector<GoalId>(book_.order)) {
    Goal& goal = book_.goals.at(id);
    if (is_settled(goal.state) || goal.queued || goal.state == GoalState::kHandedOver) continue;
    if (!goal.true_at || !book_.of(id).empty()) return;
    if (!is_there(*goal.true_at)) {
      goal.true_at.reset();
      return fail_goal(id, "goal " + to_text(id) + " was to be true without tasks, and is not");
    }
    set_state(goal, GoalState::kAchieved);
    check_network("goal " + to_text(id) + " is true");
    if (repairing()) return;
  }
}

}  // namespace skein::supervisor
