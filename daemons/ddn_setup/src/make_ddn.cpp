// SPDX-License-Identifier: Apache-2.0
#include "skein/ddn_setup/make_ddn.hpp"

#include <optional>

#include "skein/ddn/ddn_node.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/scenario_setup/setup.hpp"

namespace skein::ddn_setup {

namespace {

using scenario::Scenario;
using scenario::UavSpec;

constexpr double kHomeAltitude = 40;  ///< [m] above the ground at the start, on the way home

}  // namespace

std::unique_ptr<node::Node> make_ddn(const Scenario& scenario, const UavSpec& uav) {
  std::optional<deliberation_setup::CommonKnowledge> knowledge;
  if (scenario.planning) knowledge.emplace(scenario);
  return make_ddn(scenario, uav, scenario_setup::roster_of(scenario),
                  knowledge ? &*knowledge : nullptr);
}

std::unique_ptr<node::Node> make_ddn(const Scenario& scenario, const UavSpec& uav,
                                     const node::Roster& roster,
                                     const deliberation_setup::CommonKnowledge* knowledge) {
  ddn::DdnConfig config;
  config.uav = uav.name;
  config.degree = uav.degree;
  config.contact_policy = static_cast<decision_node::ContactPolicy>(uav.contact_loss.policy);
  config.contact_after = uav.contact_loss.after;
  config.sync_validity = scenario_setup::kSyncValidity;
  const world::Terrain terrain(scenario.world.terrain);
  config.drives = uav.model.ground.has_value();
  config.home = {uav.start.x(), uav.start.y(),
                 terrain.elevation(uav.start.x(), uav.start.y()) + kHomeAltitude};
  if (scenario.team && scenario.team->roster.number_of(uav.name)) config.team = scenario.team;
  if (scenario.planning) {
    SKEIN_EXPECTS(knowledge != nullptr);
    const auto& first_ids = scenario.planning->first_ids;
    const auto first = first_ids.find(uav.name);
    config.knowledge = knowledge->of(uav.name);
    config.world = knowledge->world();
    config.interaction = scenario.interaction;
    config.horizon = scenario.planning->horizon;
    config.consistency = scenario.planning->consistency;
    config.partner_lease = scenario.planning->partner_lease;
    if (first != first_ids.end()) config.first_task = first->second;
  }
  const std::vector<std::string> merging = scenario_setup::merging_uavs(scenario);
  if (!merging.empty() && !config.drives) {
    config.merging = {merging,
                      uav.model,
                      scenario.world.wind,
                      std::make_shared<world::Terrain>(terrain),
                      scenario.world.volumes,
                      roster.name_of(roster.ground())};
  }
  return std::make_unique<ddn::DdnNode>(config, roster);
}

}  // namespace skein::ddn_setup
