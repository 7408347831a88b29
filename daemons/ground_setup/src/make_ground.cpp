// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_setup/make_ground.hpp"

#include "skein/deliberation_setup/knowledge.hpp"
#include "skein/ground/ground_node.hpp"
#include "skein/interaction/model_hash.hpp"
#include "skein/scenario/operator_request.hpp"
#include "skein/scenario_setup/setup.hpp"

namespace skein::ground_setup {

namespace {

using scenario::Scenario;
using scenario::UavSpec;

ground_station::MissionKnowledge mission_knowledge(const Scenario& scenario) {
  ground_station::MissionKnowledge knowledge;
  if (scenario.planning) knowledge.vocabulary = deliberation_setup::vocabulary_of(scenario).value();
  for (const auto& [name, place] : scenario.world.places) knowledge.places.push_back(name);
  for (const world::Zone& zone : scenario.world.zones) knowledge.zones.push_back(zone.name);
  for (const UavSpec& uav : scenario.uavs) knowledge.vehicles.emplace(uav.name, uav.model);
  if (scenario.interaction != nullptr) {
    for (const auto& [type, hash] : hashes_of(*scenario.interaction))
      knowledge.joint_tasks[type] = hash.value;
    for (const auto& [type, model] : scenario.interaction->models) {
      if (has_roles_by_ground(model)) knowledge.by_ground.insert(type);
    }
  }
  return knowledge;
}

ground::GroundNode::ReadRequest request_reader(const Scenario& scenario) {
  auto reader =
      std::make_shared<scenario::RequestReader>(std::make_shared<const Scenario>(scenario));
  return [reader](const std::string& text)
             -> Result<std::vector<ground_station::OperatorDeed>, std::vector<std::string>> {
    auto deeds = reader->read(text);
    if (deeds) return std::move(*deeds);
    std::vector<std::string> problems;
    for (const Diagnostic& one : deeds.error().all()) problems.push_back(to_text(one));
    return tl::unexpected(std::move(problems));
  };
}

/// It says to each UAV when others come.
bool dates_by_ground(const Scenario& scenario) {
  return scenario.planning && scenario.planning->consistency == temporal::Algorithm::kCip;
}

/// What stand-ins are to know, if some model lets the ground play a role.
std::vector<decision_node::Config> played_by_ground(const Scenario& scenario) {
  std::vector<decision_node::Config> played;
  if (!scenario.planning || mission_knowledge(scenario).by_ground.empty()) return played;
  const deliberation_setup::CommonKnowledge common(scenario);
  const SharedList<std::string> names = scenario.uav_names();
  for (const UavSpec& uav : scenario.uavs) {
    decision_node::Config& config = played.emplace_back();
    config.uav = uav.name;
    config.others = decision_node::OtherUavs(names, uav.name);
    config.knowledge = common.of(uav.name);
    config.world = common.world();
    config.interaction = scenario.interaction;
    config.partner_lease = scenario.planning->partner_lease;
  }
  return played;
}

}  // namespace

std::unique_ptr<node::Node> make_ground(const Scenario& scenario) {
  ground_station::GroundConfig config;
  const decision_node::Config defaults;
  for (const UavSpec& uav : scenario.uavs) {
    ground_station::GroundUav one{uav.name, uav.degree, {}};
    one.executive.name = uav.name;
    one.executive.idle_type = "wait";
    one.executive.functional_timeout = defaults.functional_timeout;
    one.executive.interrupts_unanswered = true;
    one.executive.last_urgent_counts = true;
    one.executive.sync_validity = scenario_setup::kSyncValidity;
    config.uavs.push_back(std::move(one));
  }
  config.script = scenario.ground.script;
  config.pps = scenario.ground.pps;
  config.objects = scenario.ground.objects;
  config.dates = dates_by_ground(scenario);
  config.missions = mission_knowledge(scenario);
  auto ground = std::make_unique<ground::GroundNode>(
      config, world::Terrain(scenario.world.terrain), scenario_setup::roster_of(scenario),
      request_reader(scenario), scenario.team, played_by_ground(scenario));
  if (const auto merging = scenario_setup::merging_uavs(scenario); !merging.empty())
    ground->witness(merging);
  return ground;
}

}  // namespace skein::ground_setup
