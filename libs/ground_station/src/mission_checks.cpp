// SPDX-License-Identifier: Apache-2.0
// Missions against the domain's vocabulary; degrees and volumes against what they may be.
#include "skein/ground_station/mission_checks.hpp"

#include <algorithm>

#include "skein/foundation/fingerprint.hpp"

namespace skein::ground_station {
namespace {

using Problems = std::vector<std::string>;

constexpr const char* kNoneByGround = "its model lets the ground station play no role";

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
  for (std::string& problem : statement_problems(mission, to, now)) {
    out.push_back(std::move(problem));
  }
  return out;
}

Problems MissionChecks::problems_of(const mission::HighLevelTask& played, const Addressee& to,
                                    MissionTime now) const {
  Problems out;
  if (mission::deliberates(to.degree)) {
    out.push_back(to.name + " is at degree " + std::to_string(to.degree) +
                  ": it plays its roles itself");
  }
  if (!knowledge_.joint_tasks.contains(played.name)) {
    out.push_back("the ground station has no model of '" + played.name + "'");
  } else if (!knowledge_.by_ground.contains(played.name)) {
    out.push_back(played.name + ": " + kNoneByGround);
  }
  for (std::string& problem : joint_problems(played, to)) out.push_back(std::move(problem));
  mission::UnitMission mission;  // of its own
  mission.id = mission::MissionId(1);
  mission.tasks.push_back(played);
  for (std::string& problem : statement_problems(mission, to, now)) {
    out.push_back(std::move(problem));
  }
  return out;
}

Problems MissionChecks::statement_problems(const mission::UnitMission& mission, const Addressee& to,
                                           MissionTime now) const {
  if (!knowledge_.vocabulary) return {};
  const auto vehicle = knowledge_.vehicles.find(to.name);
  const mission::Surroundings surroundings{
      knowledge_.places, knowledge_.zones, team_,
      vehicle == knowledge_.vehicles.end() ? nullptr : &vehicle->second};
  return mission::problems_of(mission, *knowledge_.vocabulary, surroundings, now);
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
    if (!mission::deliberates(degree)) {
      if (name != to.name && !knowledge_.by_ground.contains(task.name)) {
        say(name + " is at degree " + std::to_string(degree) + " and does not deliberate, and " +
            kNoneByGround);
      }
      if (knowledge_.by_ground.contains(task.name)) continue;  // the ground's version counts
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
