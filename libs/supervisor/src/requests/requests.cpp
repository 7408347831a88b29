// SPDX-License-Identifier: Apache-2.0
#include "requests/requests.hpp"

#include <algorithm>
#include <utility>

namespace skein::supervisor {

Requests::Requests(const Rooms& rooms)
    : beliefs_(rooms.beliefs),
      hand_over_(rooms.hand_over),
      contingencies_(rooms.contingencies),
      committer_(rooms.committer),
      agenda_(rooms.agenda),
      out_(rooms.out),
      book_(rooms.book) {}

bool Requests::answer(const std::string& cause, const std::string& inputs,
                      const std::vector<std::string>& problems) {
  out_.add(Answer{problems.empty(), problems});
  out_.decide({"0 user request", cause, inputs,
               problems.empty() ? "accepted" : "refused: " + joined(problems), now()});
  return problems.empty();
}

// ---- missions ----

std::vector<std::string> Requests::problems_of_mission(const mission::UnitMission& mission) const {
  if (!hand_over_.engaged()) return {"the UAV does not plan at this degree of autonomy"};
  world::VehicleModel vehicle = beliefs_.model();
  const auto is_broken = [&](const auto& sensor) {
    return beliefs_.broken().count(sensor.device) != 0;
  };
  vehicle.sensors.erase(std::remove_if(vehicle.sensors.begin(), vehicle.sensors.end(), is_broken),
                        vehicle.sensors.end());
  mission::Surroundings around;
  for (const auto& [name, place] : beliefs_.world().places) around.places.push_back(name);
  for (const world::Zone& zone : beliefs_.world().zones) around.zones.push_back(zone.name);
  around.uavs = beliefs_.knowledge().team.values();
  around.vehicle = &vehicle;
  std::vector<std::string> problems =
      mission::problems_of(mission, beliefs_.knowledge().vocabulary, around, now());
  if (missions_.knows(mission.id.value())) {
    problems.push_back("mission " + to_text(mission.id) + " is known already");
  }
  for (std::string& problem : problems_of_goals(mission)) problems.push_back(std::move(problem));
  return problems;
}

std::vector<std::string> Requests::problems_of_goals(const mission::UnitMission& mission) const {
  std::vector<std::string> problems;
  for (const mission::HighLevelTask& task : mission.tasks) {
    if (book_.knows(task.id)) {
      problems.push_back("high-level task " + to_text(task.id) + " is known already");
    }
    for (const mission::GoalBound& bound : task.after) {
      const bool here = std::any_of(mission.tasks.begin(), mission.tasks.end(),
                                    [&](const auto& one) { return one.id == bound.goal; });
      if (here || book_.goals.count(bound.goal) != 0) continue;
      const bool was = book_.knows(bound.goal);
      problems.push_back("high-level task " + to_text(bound.goal) + ", after which " +
                         to_text(task.id) + " is to come, is " +
                         (was ? "over for too long to count from it" : "not known"));
    }
  }
  return problems;
}

void Requests::enter(const mission::UnitMission& mission, const std::string& cause) {
  missions_.set(mission.id.value(), 1);
  for (const mission::HighLevelTask& task : mission.tasks) {
    Goal goal;
    goal.task = task;
    goal.mission = mission.id;
    goal.asked_by = mission.asked_by;
    goal.queued = true;
    Goal& entered = book_.goals.emplace(task.id, std::move(goal)).first->second;
    book_.order.push_back(task.id);
    out_.set_state(entered, GoalState::kReceived);
  }
  agenda_.hurry();
  agenda_.add(Pending{mission.id, mission.placement, mission.interrupt, mission.any, cause, now()});
}

void Requests::add(const mission::UnitMission& mission) {
  const std::vector<std::string> problems = problems_of_mission(mission);
  std::vector<GoalId> ids;
  for (const auto& task : mission.tasks) ids.push_back(task.id);
  const std::string cause = "mission " + to_text(mission.id) + " of " + mission.asked_by;
  if (!answer(cause, list_of("goals", ids), problems)) return;
  if (!mission.evaluate) return enter(mission, cause);
  agenda_.add(Evaluation{mission, cause, now()});
}

// ---- cancellations ----

std::vector<GoalId> Requests::goals_named(const mission::CancelGoals& named,
                                          std::vector<std::string>& problems) const {
  const bool by_mission = named.mission != mission::MissionId();
  const bool all = named.goals.empty() && !by_mission;
  for (const GoalId id : named.goals) {
    if (!book_.knows(id)) {
      problems.push_back("high-level task " + to_text(id) + " is not known");
    }
  }
  if (by_mission && !missions_.knows(named.mission.value())) {
    problems.push_back("mission " + to_text(named.mission) + " is not known");
  }
  std::vector<GoalId> result;
  for (const GoalId id : book_.order) {
    const Goal& goal = book_.goals.at(id);
    // A part of a mapping goes with it.
    const GoalId asked = whole_of(goal.task).value_or(id);
    const auto whole = book_.goals.find(asked);
    const bool listed = std::any_of(named.goals.begin(), named.goals.end(),
                                    [&](GoalId one) { return one == id || one == asked; });
    const bool meant =
        all || listed ||
        (by_mission && whole != book_.goals.end() && whole->second.mission == named.mission);
    if (meant && !is_settled(goal.state)) result.push_back(id);
  }
  if (result.empty() && !all && problems.empty()) problems.push_back("all of it is over already");
  return result;
}

void Requests::cancel(const CancelMission& input) {
  std::vector<std::string> problems;
  const std::vector<GoalId> goals = goals_named(input.goals, problems);
  const std::string cause = "cancelled by " + input.asked_by;
  const bool accepted = answer(cause, list_of("goals", goals), problems);
  if (accepted && !goals.empty()) cancel(goals, input.goals.interrupt, cause);
}

void Requests::cancel(const std::vector<GoalId>& goals, bool interrupt, const std::string& cause) {
  std::vector<GoalId> gone;
  std::set<GoalId> stopped;
  for (const GoalId id : goals) {
    const bool goes_on = book_.goals.at(id).state == GoalState::kUnderWay && book_.has_in_hand(id);
    if (goes_on && !interrupt) continue;
    gone.push_back(id);
    stopped.insert(id);
  }
  const std::set<GoalId> falling = book_.falling_with(stopped);
  committer_.retire(falling);
  const std::vector<GoalId> left =
      hand_over_.engaged() ? left_to_plan(gone) : std::vector<GoalId>();
  for (const GoalId id : gone) {
    book_.goals.at(id).queued = false;
    out_.set_state(book_.goals.at(id), GoalState::kCancelled, cause);
  }
  if (!hand_over_.engaged()) {
    for (const GoalId id : falling) hand_over_.hand_over_goal(id);
  }
  drop_cancelled_missions();
  committer_.reschedule();
  if (!left.empty()) agenda_.plan_anew(std::nullopt, false, cause);
  out_.decide({"2 cancel", cause, list_of("goals", gone),
               left.empty() ? "nothing is to be planned anew" : list_of("to plan anew:", left),
               now()});
}

// What comes before all that is cancelled and has a plan keeps it; then nothing is left to plan.
std::vector<GoalId> Requests::left_to_plan(const std::vector<GoalId>& gone) const {
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

void Requests::drop_cancelled_missions() {
  std::vector<mission::MissionId> cancelled;
  for (const Pending& one : agenda_.pending()) {
    const bool waits = std::any_of(book_.goals.begin(), book_.goals.end(), [&](const auto& goal) {
      return goal.second.queued && goal.second.mission == one.id;
    });
    if (!waits) cancelled.push_back(one.id);
  }
  for (const mission::MissionId id : cancelled) {
    out_.add(MissionDecided{{id, false, {"cancelled"}}});
    if (agenda_.plans() && agenda_.job()->mission == id) agenda_.abandon_job();
    agenda_.take(id);
  }
}

// ---- the world ----

std::vector<std::string> Requests::problems_of_volume(const mission::ChangeWorld& change) const {
  if (!change.remove) return mission::problems_of(change);
  const auto& volumes = beliefs_.world().volumes;
  const bool closed = std::any_of(volumes.begin(), volumes.end(),
                                  [&](const auto& one) { return one.name == change.volume.name; });
  if (closed) return {};
  return {"no volume '" + change.volume.name + "' is closed"};
}

bool Requests::change_world(const mission::ChangeWorld& change) {
  const std::string cause = to_text(change);
  if (change.place || change.ground) {
    if (!answer(cause, "world", mission::problems_of(change))) return false;
    world::Vector3 moved = world::Vector3::Zero();
    if (change.place) {
      const auto known = beliefs_.world().places.find(change.place->name);
      if (known != beliefs_.world().places.end()) moved = change.place->at - known->second;
    }
    beliefs_.learn(change);
    if (hand_over_.engaged() && change.place)
      contingencies_.look_elsewhere(change.place->name, moved, cause + " elsewhere");
    return false;
  }
  if (!answer(cause, change.volume.name, problems_of_volume(change))) return false;
  beliefs_.close(change);
  return !change.remove;
}

}  // namespace skein::supervisor
