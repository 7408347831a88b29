// SPDX-License-Identifier: Apache-2.0
#include "skein/assembly/assembly.hpp"

#include "skein/ddn_setup/make_ddn.hpp"
#include "skein/deliberation_setup/knowledge.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/ground_setup/make_ground.hpp"
#include "skein/scenario_setup/setup.hpp"
#include "skein/sim_setup/make_sim.hpp"

namespace skein::assembly {

using scenario::Scenario;

namespace {

std::unique_ptr<node::Node> make_other_than_uav(const Scenario& scenario, const std::string& name) {
  if (name == "ground") return ground_setup::make_ground(scenario);
  SKEIN_EXPECTS(scenario_setup::roster_of(scenario).find(name) != nullptr);
  return sim_setup::make_sim(scenario, name);
}

}  // namespace

std::unique_ptr<node::Node> make_node(const Scenario& scenario, const std::string& name) {
  if (const scenario::UavSpec* uav = scenario.find_uav(name))
    return ddn_setup::make_ddn(scenario, *uav);
  return make_other_than_uav(scenario, name);
}

NodeMaker::NodeMaker(const Scenario& scenario)
    : scenario_(scenario), roster_(scenario_setup::roster_of(scenario)) {
  if (scenario.planning) knowledge_.emplace(scenario);
}

std::unique_ptr<node::Node> NodeMaker::operator()(const std::string& name) const {
  if (const scenario::UavSpec* uav = scenario_.find_uav(name))
    return ddn_setup::make_ddn(scenario_, *uav, roster_, knowledge_ ? &*knowledge_ : nullptr);
  return make_other_than_uav(scenario_, name);
}

Diagnostics check_assembly(const Scenario& scenario) {
  Diagnostics diagnostics = sim_setup::simulation_problems(scenario);
  diagnostics.append(scenario_setup::radio_problems(scenario));
  diagnostics.append(deliberation_setup::planning_problems(scenario));
  diagnostics.append(deliberation_setup::joint_task_problems(scenario));
  diagnostics.append(deliberation_setup::global_mission_problems(scenario));
  return diagnostics;
}

Result<Scenario, Diagnostics> load_scenario(const std::string& path,
                                            const scenario_setup::Overrides& overrides) {
  return scenario_setup::load_scenario(path, overrides, check_assembly);
}

node::VirtualConfig virtual_config(const Scenario& scenario) {
  node::VirtualConfig config;
  config.seed = scenario.seed;
  config.time_limit = scenario.duration_limit;
  config.heartbeat_period = scenario.radio.heartbeat;
  config.capacity = scenario_setup::capacity_of(scenario);
  if (scenario.planning)
    config.jobs = {scenario.planning->takes_least, scenario.planning->takes_most};
  config.silent_cuts = scenario.radio.silent;
  config.meets_when_told = true;
  for (const scenario::KillSpec& kill : scenario.faults.kills) {
    std::optional<MissionTime> restart;
    if (kill.restart_after) restart = kill.at + *kill.restart_after;
    config.crashes.push_back({kill.at, kill.node, restart, !kill.forgets});
  }
  return config;
}

}  // namespace skein::assembly
