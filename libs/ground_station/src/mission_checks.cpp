// SPDX-License-Identifier: Apache-2.0
// Missions against the domain's vocabulary; degrees and volumes against what they may be.
#include "skein/ground_station/mission_checks.hpp"

#include <algorithm>

#include "skein/foundation/fingerprint.hpp"

namespace skein::ground_station {
namespace {

using Problems = std::vector<std::string>;

Problems problems(const mission::ChangeDegree& change) {
  if (change.degree >= mission::kLeastDegree && change.degree <= mission::kGreatestDegree) {
    return {};
  }
  return {"there is no degree " + std::to_string(change.degree) + ": they go from " +
          std::to_string(mission::kLeastDegree) + " to " +
          std::to_string(mission::kGreatestDegree)};
}

const std::vector<std::string>* members_of(const mission::HighLevelTask& task) {
  for (const mission::Argument& argument : task.arguments) {
    if (const auto* members = std::get_if<std::vector<std::string>>(&argument)) return members;
  }
  return nullptr;
}

}  // namespace

Problems MissionChecks::problems_of(const Request& request, const Addressee& to,
                                    MissionTime now) const {
  if (const auto* mission = std::get_if<mission::UnitMission>(&request)) {
    return problems(*mission, to, now);
  }
  if (const auto* change = std::get_if<mission::ChangeDegree>(&request)) {
    return ground_station::problems(*change);
  }
  if (const auto* change = std::get_if<mission::ChangeWorld>(&request)) {
    return mission::problems_of(*change);
  }
  return {};
}

Problems MissionChecks::problems(const mission::UnitMission& mission, const Addressee& to,
                                 MissionTime now) const {
  Problems out;
  if (to.degree < 4) {
    out.push_back(to.name + " is at degree " + std::to_string(to.degree) +
                  ": missions are planned at degree 4");
  }
  for (const mission::GoalStatus& goal : to.goals) {
    const bool is_again = std::any_of(mission.tasks.begin(), mission.tasks.end(),
                                      [&](const auto& task) { return task.id == goal.id; });
    if (is_again) {
      out.push_back("high-level task " + skein::to_text(goal.id) +
                    " is known already: " + goal.statement);
    }
  }
  for (const mission::HighLevelTask& task : mission.tasks) {
    for (std::string& problem : joint_problems(task, to)) out.push_back(std::move(problem));
  }
  if (!knowledge_.vocabulary) return out;
  const auto vehicle = knowledge_.vehicles.find(to.name);
  const mission::Surroundings surroundings{
      knowledge_.places, knowledge_.zones, team_,
      vehicle == knowledge_.vehicles.end() ? nullptr : &vehicle->second};
  for (std::string& problem :
       mission::problems_of(mission, *knowledge_.vocabulary, surroundings, now)) {
    out.push_back(std::move(problem));
  }
  return out;
}

// Names that are no UAVs are the vocabulary's business.
Problems MissionChecks::joint_problems(const mission::HighLevelTask& task,
                                       const Addressee& to) const {
  const auto model = knowledge_.joint_tasks.find(task.name);
  const std::vector<std::string>* members = members_of(task);
  if (model == knowledge_.joint_tasks.end() || members == nullptr) return {};
  Problems out;
  const auto say = [&](const std::string& what) { out.push_back(task.name + ": " + what); };
  if (std::find(members->begin(), members->end(), to.name) == members->end()) {
    say(to.name + " is not among its members");
  }
  for (const std::string& name : *members) {
    const auto mate = to.team.find(name);
    if (mate == to.team.end()) continue;
    const auto& [degree, models] = mate->second;
    if (name != to.name && !mission::deliberates(degree)) {
      say(name + " is at degree " + std::to_string(degree) + " and does not deliberate");
    }
    const auto version = models.find(task.name);
    if (models.empty()) continue;
    if (version == models.end()) {
      say(name + " has no model of it");
    } else if (version->second != model->second) {
      say(name + " has version " + fingerprint_text(version->second) +
          " of its model, the ground station " + fingerprint_text(model->second));
    }
  }
  return out;
}

}  // namespace skein::ground_station
