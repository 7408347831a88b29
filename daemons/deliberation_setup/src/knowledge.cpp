// SPDX-License-Identifier: Apache-2.0
#include "skein/deliberation_setup/knowledge.hpp"

#include <algorithm>
#include <utility>

#include "script_actions.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/interaction/role_fit.hpp"
#include "skein/mission/degree.hpp"
#include "skein/team/abilities.hpp"
#include "skein/team/conflicts.hpp"
#include "skein/world/world_builder.hpp"

namespace skein::deliberation_setup {

using scenario::Scenario;
using scenario::UavSpec;

namespace {

world::WorldFile file_of(const Scenario& scenario) {
  const scenario::PlanningSpec& planning = *scenario.planning;
  world::WorldFile file;
  file.file = scenario.file;
  file.origin = scenario.world.origin;
  file.terrain = scenario.world.terrain;
  file.wind = scenario.world.wind;
  file.airspace.ceiling = planning.ceiling;
  file.airspace.voxel = planning.voxel;
  file.airspace.mark = {0, "planning"};
  file.volumes = scenario.world.volumes;
  file.ground = planning.ground;
  file.radio = scenario.radio.model;
  file.zones = scenario.world.zones;
  for (const auto& [name, place] : scenario.world.places) file.places[name] = {place, {}};
  return file;
}

supervisor::DomainText domain_of(const Scenario& scenario) {
  return {scenario.planning->domain_path, scenario.planning->domain};
}

}  // namespace

Result<world::World, Diagnostics> world_of(const Scenario& scenario) {
  SKEIN_EXPECTS(scenario.planning.has_value());
  return world::build_world(file_of(scenario));
}

namespace {

void add_use(mission::Vocabulary& vocabulary, const std::string& device, const std::string& use) {
  const auto [first, last] = vocabulary.serves.equal_range(device);
  const bool known = std::any_of(first, last, [&](const auto& one) { return one.second == use; });
  if (!known) vocabulary.serves.emplace(device, use);
}

}  // namespace

Result<mission::Vocabulary, Diagnostics> vocabulary_of(const Scenario& scenario) {
  SKEIN_EXPECTS(scenario.planning.has_value());
  auto vocabulary = supervisor::vocabulary_of(domain_of(scenario));
  if (!vocabulary) return vocabulary;
  for (const UavSpec& uav : scenario.uavs)
    for (const world::SensorModel& sensor : uav.model.sensors)
      for (const std::string& use : sensor.serves) add_use(*vocabulary, sensor.device, use);
  return vocabulary;
}

namespace {

supervisor::Partner partner_of(const Scenario& scenario, const world::Terrain& terrain,
                               const UavSpec& uav) {
  const auto& altitudes = scenario.planning->altitudes;
  const auto own = altitudes.find(uav.name);
  return {uav.name,
          uav.model,
          {uav.start.x(), uav.start.y(), terrain.elevation(uav.start.x(), uav.start.y())},
          uav.model.ground         ? 0
          : own != altitudes.end() ? own->second
                                   : scenario.planning->altitude};
}

}  // namespace

CommonKnowledge::CommonKnowledge(const Scenario& scenario)
    : team_(scenario.uav_names()), domain_(domain_of(scenario)) {
  auto vocabulary = deliberation_setup::vocabulary_of(scenario);
  SKEIN_EXPECTS(vocabulary.has_value());
  vocabulary_ = std::move(*vocabulary);
  const world::Terrain terrain(scenario.world.terrain);
  std::vector<supervisor::Partner> uavs;
  for (const UavSpec& one : scenario.uavs) uavs.push_back(partner_of(scenario, terrain, one));
  uavs_ = std::move(uavs);
  world_ = std::make_shared<const world::World>(world_of(scenario).value());
}

std::shared_ptr<const supervisor::Knowledge> CommonKnowledge::of(const std::string& uav) const {
  const auto own = std::ranges::find(uavs_, uav, &supervisor::Partner::uav);
  SKEIN_EXPECTS(own != uavs_.end());
  supervisor::Knowledge knowledge;
  knowledge.uav = own->uav;
  knowledge.vehicle = own->vehicle;
  knowledge.home = own->home;
  knowledge.altitude = own->altitude;
  knowledge.team = team_;
  knowledge.partners = uavs_;
  knowledge.domain = domain_;
  knowledge.vocabulary = vocabulary_;
  return std::make_shared<const supervisor::Knowledge>(std::move(knowledge));
}

namespace {

/// "watch × 1 and relay × at least 1, or …": how many each variant is for.
std::string teams_of(const interaction::Model& model) {
  std::vector<std::string> variants;
  for (const interaction::Variant& variant : model.variants) {
    std::vector<std::string> roles;
    for (const auto& [role, arity] : variant.table.arities)
      roles.push_back(role + " × " + interaction::to_text(arity));
    variants.push_back(joined(roles, " and "));
  }
  return joined(variants, ", or ");
}

/// Of a high-level task, at the place where it is written; "ground.script" where that is not known.
struct TaskPlace {
  std::string file;
  world::Mark mark;

  TaskPlace(const Scenario& scenario, const scenario::TaskMarks& marks, const std::string& uav,
            mission::GoalId task)
      : file(scenario.file), mark{0, "ground.script"} {
    if (const auto known = marks.find({uav, task}); known != marks.end()) mark = known->second;
  }
  Diagnostic at(const std::string& problem, const std::string& wanted,
                const std::string& nearest) const {
    return {file, mark.line, 0, mark.path, problem, wanted, nearest};
  }
};

/// What is wrong with the members of a joint task that a UAV is asked for.
void check_members(const Scenario& scenario, const std::string& uav,
                   const mission::HighLevelTask& task, const TaskPlace& place,
                   const std::vector<std::string>& members, Diagnostics& diagnostics) {
  const auto add = [&](const std::string& problem, const std::string& wanted,
                       const std::string& nearest) {
    diagnostics.add(place.at(task.name + " of " + uav + ": " + problem, wanted, nearest));
  };
  if (std::find(members.begin(), members.end(), uav) == members.end()) {
    add("it is not among the members", "the UAV itself among them", "");
  }
  const interaction::Model& model = scenario.interaction->models.at(task.name);
  if (interaction::variant_for(model, members.size()) == nullptr) {
    add("no variant is for " + std::to_string(members.size()) + " UAVs", teams_of(model), "");
  }
  for (const std::string& one : members) {
    const UavSpec* member = scenario.find_uav(one);
    if (member == nullptr) {
      add("no UAV '" + one + "'", "a UAV", nearest_name(one, scenario.uav_names()));
    } else if (!mission::deliberates(member->degree) && !has_roles_by_ground(model)) {
      add(one + " does not deliberate",
          "degree 4 for all members, or a model that lets the ground station play roles", "");
    }
  }
}

/// What the ground is asked to play for a UAV.
void check_played(const Scenario& scenario, const ground_station::PlayRole& play,
                  const TaskPlace& place, Diagnostics& diagnostics) {
  const auto add = [&](const std::string& problem, const std::string& wanted) {
    diagnostics.add(place.at("play for " + play.uav + ": " + problem, wanted, ""));
  };
  const auto model = scenario.interaction->models.find(play.task.name);
  if (model == scenario.interaction->models.end()) {
    add("no interaction model '" + play.task.name + "'", "the type of a joint task");
  } else if (!has_roles_by_ground(model->second)) {
    add("the model of '" + play.task.name + "' lets the ground station play no role",
        "by-ground: [ROLE] in a variant of it");
  }
}

void check_task(const Scenario& scenario, const std::string& uav,
                const mission::HighLevelTask& task, const TaskPlace& place,
                Diagnostics& diagnostics) {
  if (!scenario.interaction->models.contains(task.name)) return;
  for (const mission::Argument& argument : task.arguments) {
    const auto* members = std::get_if<std::vector<std::string>>(&argument);
    if (members != nullptr) check_members(scenario, uav, task, place, *members, diagnostics);
  }
}

void check_action(const Scenario& scenario, const ground_station::Action& action,
                  Diagnostics& diagnostics) {
  if (const auto* sent = std::get_if<ground_station::SendMission>(&action)) {
    for (const mission::HighLevelTask& task : sent->mission.tasks) {
      const TaskPlace place(scenario, scenario.ground.asked, sent->uav, task.id);
      check_task(scenario, sent->uav, task, place, diagnostics);
    }
  } else if (const auto* played = std::get_if<ground_station::PlayRole>(&action)) {
    const TaskPlace place(scenario, scenario.ground.played, played->uav, played->task.id);
    check_task(scenario, played->uav, played->task, place, diagnostics);
    check_played(scenario, *played, place, diagnostics);
  }
}

}  // namespace

Diagnostics joint_task_problems(const Scenario& scenario) {
  Diagnostics diagnostics;
  if (scenario.interaction == nullptr) return diagnostics;
  for_each_action(scenario.ground.script, [&](const auto& action, MissionTime) {
    check_action(scenario, action, diagnostics);
  });
  return diagnostics;
}

namespace {

/// What a team can do.
struct Means {
  mission::Vocabulary vocabulary;
  team::Vehicles vehicles;
};

void check_global_mission(const Scenario& scenario, const Means& means,
                          const ground_station::Action& action, MissionTime begin,
                          Diagnostics& diagnostics) {
  const auto refuse = [&](mission::MissionId mission,
                          const std::vector<team::Conflict>& conflicts) {
    for (const team::Conflict& one : conflicts) {
      const TaskPlace place(scenario, scenario.ground.asked, "", one.task);
      diagnostics.add(place.at("global mission " + to_text(mission) + ": " + one.sentence,
                               "tasks that can all be done", ""));
    }
  };
  const auto* sent = std::get_if<ground_station::SendGlobalMission>(&action);
  if (sent == nullptr) return;
  const team::GlobalMission& mission = sent->mission;
  const team::Roster& roster = scenario.team->roster;
  refuse(mission.id,
         team::conflicts_of(mission, roster, means.vocabulary, scenario.uav_names(), begin));
  refuse(mission.id, team::lacks_of(mission, roster, means.vehicles));
}

}  // namespace

Diagnostics global_mission_problems(const Scenario& scenario) {
  Diagnostics diagnostics;
  if (!scenario.team || !scenario.planning) return diagnostics;
  auto vocabulary = vocabulary_of(scenario);
  if (!vocabulary) return diagnostics;
  Means means{std::move(*vocabulary), {}};
  for (const UavSpec& uav : scenario.uavs) means.vehicles.emplace(uav.name, uav.model);
  for_each_action(scenario.ground.script, [&](const auto& action, MissionTime begin) {
    check_global_mission(scenario, means, action, begin, diagnostics);
  });
  return diagnostics;
}

Diagnostics planning_problems(const Scenario& scenario) {
  Diagnostics diagnostics;
  if (scenario.planning) {
    if (const auto vocabulary = vocabulary_of(scenario); !vocabulary) {
      diagnostics.append(vocabulary.error());
    }
    if (const auto world = world_of(scenario); !world) diagnostics.append(world.error());
    return diagnostics;
  }
  for (const UavSpec& uav : scenario.uavs) {
    if (uav.degree < 4) continue;
    diagnostics.add({scenario.file, 0, 0, "",
                     "degree " + std::to_string(uav.degree) + " of " + uav.name +
                         ": nothing is said of planning on board",
                     "planning: {domain: FILE}", ""});
  }
  return diagnostics;
}

}  // namespace skein::deliberation_setup
