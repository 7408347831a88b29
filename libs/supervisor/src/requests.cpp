// SPDX-License-Identifier: Apache-2.0
// Operators 0 and 2: what users ask for. Source: T IV.4.2 (SCD-0, SCD-2), spec 6.2.
#include <algorithm>

#include "core.hpp"

namespace skein::supervisor {

// ---- missions ----

std::vector<std::string> Supervisor::Core::problems_of_mission(
    const mission::UnitMission& mission) const {
  if (!engaged_) return {"the UAV does not plan at this degree of autonomy"};
  world::VehicleModel vehicle = config_.knowledge->vehicle;
  const auto is_broken = [&](const auto& sensor) { return broken_.count(sensor.device) != 0; };
  vehicle.sensors.erase(std::remove_if(vehicle.sensors.begin(), vehicle.sensors.end(), is_broken),
                        vehicle.sensors.end());
  mission::Surroundings around;
  for (const auto& [name, place] : world_->places) around.places.push_back(name);
  for (const world::Zone& zone : world_->zones) around.zones.push_back(zone.name);
  around.uavs = config_.knowledge->team;
  around.vehicle = &vehicle;
  std::vector<std::string> problems =
      mission::problems_of(mission, config_.knowledge->vocabulary, around, now_);
  if (missions_.count(mission.id) != 0) {
    problems.push_back("mission " + to_text(mission.id) + " is known already");
  }
  for (const mission::HighLevelTask& task : mission.tasks) {
    if (book_.goals.count(task.id) != 0) {
      problems.push_back("high-level task " + to_text(task.id) + " is known already");
    }
    for (const mission::GoalBound& bound : task.after) {
      const bool here = std::any_of(mission.tasks.begin(), mission.tasks.end(),
                                    [&](const auto& one) { return one.id == bound.goal; });
      if (here || book_.goals.count(bound.goal) != 0) continue;
      problems.push_back("high-level task " + to_text(bound.goal) + ", after which " +
                         to_text(task.id) + " is to come, is not known");
    }
  }
  return problems;
}

void Supervisor::Core::enter(const mission::UnitMission& mission) {
  missions_.insert(mission.id);
  for (const mission::HighLevelTask& task : mission.tasks) {
    Goal goal;
    goal.task = task;
    goal.mission = mission.id;
    goal.asked_by = mission.asked_by;
    goal.queued = true;
    Goal& entered = book_.goals.emplace(task.id, std::move(goal)).first->second;
    book_.order.push_back(task.id);
    set_state(entered, GoalState::kReceived);
  }
  hurry();
  pending_.push_back({mission.id, mission.placement, mission.interrupt, mission.any,
                      "mission " + to_text(mission.id) + " of " + mission.asked_by, now_});
}

void Supervisor::Core::on(const AddMission& input) {
  const mission::UnitMission& mission = input.mission;
  const std::vector<std::string> problems = problems_of_mission(mission);
  out_.push_back(Answer{problems.empty(), problems});
  std::vector<GoalId> ids;
  for (const auto& task : mission.tasks) ids.push_back(task.id);
  const std::string cause = "mission " + to_text(mission.id) + " of " + mission.asked_by;
  decide({"0 user request", cause, list_of("goals", ids),
          problems.empty() ? "accepted" : "refused: " + joined(problems), now_});
  if (!problems.empty()) return;
  if (!mission.evaluate) return enter(mission);
  evaluations_.push_back({mission, cause, now_});
}

// ---- cancellations ----

std::vector<GoalId> Supervisor::Core::goals_named(const mission::CancelGoals& named,
                                                  std::vector<std::string>& problems) const {
  const bool by_mission = named.mission != mission::MissionId();
  const bool all = named.goals.empty() && !by_mission;
  for (const GoalId id : named.goals) {
    if (book_.goals.count(id) == 0) {
      problems.push_back("high-level task " + to_text(id) + " is not known");
    }
  }
  if (by_mission && missions_.count(named.mission) == 0) {
    problems.push_back("mission " + to_text(named.mission) + " is not known");
  }
  std::vector<GoalId> result;
  for (const GoalId id : book_.order) {
    const Goal& goal = book_.goals.at(id);
    const bool listed = std::find(named.goals.begin(), named.goals.end(), id) != named.goals.end();
    const bool meant = all || listed || (by_mission && goal.mission == named.mission);
    if (meant && !is_settled(goal.state)) result.push_back(id);
  }
  if (result.empty() && !all && problems.empty()) problems.push_back("all of it is over already");
  return result;
}

void Supervisor::Core::on(const CancelMission& input) {
  std::vector<std::string> problems;
  const std::vector<GoalId> goals = goals_named(input.goals, problems);
  out_.push_back(Answer{problems.empty(), problems});
  const std::string cause = "cancelled by " + input.asked_by;
  decide({"0 user request", cause, list_of("goals", goals),
          problems.empty() ? "accepted" : "refused: " + joined(problems), now_});
  if (problems.empty() && !goals.empty()) cancel(goals, input.goals.interrupt, cause);
}

void Supervisor::Core::cancel(const std::vector<GoalId>& goals, bool interrupt,
                              const std::string& cause) {
  std::vector<GoalId> gone;
  std::set<GoalId> stopped;
  for (const GoalId id : goals) {
    const bool goes_on = book_.goals.at(id).state == GoalState::kUnderWay && book_.has_in_hand(id);
    if (goes_on && !interrupt) continue;
    gone.push_back(id);
    stopped.insert(id);
  }
  const std::set<GoalId> falling = book_.falling_with(stopped);
  retire(falling);
  const std::vector<GoalId> left = engaged_ ? left_to_plan(gone) : std::vector<GoalId>();
  for (const GoalId id : gone) {
    book_.goals.at(id).queued = false;
    set_state(book_.goals.at(id), GoalState::kCancelled, cause);
  }
  if (!engaged_) {
    for (const GoalId id : falling) hand_over_goal(id);
  }
  drop_cancelled_missions();
  reschedule();
  if (!left.empty()) need(std::nullopt, false, cause);
  decide({"2 cancel", cause, list_of("goals", gone),
          left.empty() ? "nothing is to be planned anew" : list_of("to plan anew:", left), now_});
}

// What comes before all that is cancelled and has a plan keeps it; then nothing is left to plan.
std::vector<GoalId> Supervisor::Core::left_to_plan(const std::vector<GoalId>& gone) const {
  const auto is_gone = [&](GoalId id) {
    return std::find(gone.begin(), gone.end(), id) != gone.end();
  };
  std::vector<GoalId> left;
  const std::vector<GoalId> free = book_.free_goals();
  bool touched = false, behind = false;
  for (const GoalId id : book_.order) {
    behind = behind || (is_gone(id) && !book_.goals.at(id).queued);
    if (is_gone(id) || std::find(free.begin(), free.end(), id) == free.end()) continue;
    left.push_back(id);
    touched = touched || behind || (!book_.is_planned(id) && !book_.goals.at(id).true_at);
  }
  return touched ? left : std::vector<GoalId>();
}

void Supervisor::Core::drop_cancelled_missions() {
  for (auto it = pending_.begin(); it != pending_.end();) {
    const bool waits = std::any_of(book_.goals.begin(), book_.goals.end(), [&](const auto& one) {
      return one.second.queued && one.second.mission == it->id;
    });
    if (!waits) out_.push_back(MissionDecided{{it->id, false, {"cancelled"}}});
    if (!waits && job_ && job_->mission == it->id && !job_->evaluation) abandon_job();
    it = waits ? it + 1 : pending_.erase(it);
  }
}

// ---- the world ----

void Supervisor::Core::set_volume(const mission::ChangeWorld& change) {
  auto changed = std::make_shared<world::World>(*world_);
  std::vector<world::Volume>& volumes = changed->volumes;
  volumes.erase(std::remove_if(volumes.begin(), volumes.end(),
                               [&](const auto& one) { return one.name == change.volume.name; }),
                volumes.end());
  if (!change.remove) volumes.push_back(change.volume);
  world_ = std::move(changed);
  ++world_revision_;
}

void Supervisor::Core::on(const WorldChanged& input) {
  const mission::ChangeWorld& change = input.change;
  if (change.place || change.ground) return learn(change);
  const auto& volumes = world_->volumes;
  std::vector<std::string> problems;
  if (!change.remove) {
    problems = mission::problems_of(change);
  } else if (std::none_of(volumes.begin(), volumes.end(),
                          [&](const auto& one) { return one.name == change.volume.name; })) {
    problems.push_back("no volume '" + change.volume.name + "' is closed");
  }
  out_.push_back(Answer{problems.empty(), problems});
  const std::string cause = to_text(change);
  decide({"0 user request", cause, change.volume.name,
          problems.empty() ? "accepted" : "refused: " + joined(problems), now_});
  if (!problems.empty()) return;
  set_volume(change);
  if (engaged_ && !change.remove) check_air(cause);
}

}  // namespace skein::supervisor
