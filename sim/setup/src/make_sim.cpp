// SPDX-License-Identifier: Apache-2.0
#include "skein/sim_setup/make_sim.hpp"

#include <algorithm>

#include "skein/scenario_setup/setup.hpp"
#include "skein/sim_node/sim_node.hpp"

namespace skein::sim_setup {

namespace {

using scenario::Scenario;
using scenario::UavSpec;

constexpr const char* kSimulator = "sim";

/// Of the simulator, or of a functional layer that plays some of the vehicles.
sim::SimulatorConfig simulator_config(const Scenario& scenario, const std::string& node) {
  sim::SimulatorConfig config{.terrain = world::Terrain(scenario.world.terrain)};
  config.wind = scenario.world.wind;
  config.objects = scenario.world.objects;
  for (const UavSpec& uav : scenario.uavs) {
    const bool played = node == (uav.functional.empty() ? kSimulator : uav.functional);
    config.vehicles.push_back(
        {uav.name, uav.model, uav.start, uav.heading, uav.energy, uav.speed_factor, played});
  }
  config.tells_world = node == kSimulator;
  config.radio = scenario.radio.model;
  config.ground_station = scenario.ground.position;
  for (const scenario::CutSpec& cut : scenario.radio.cuts) {
    config.cuts.push_back({cut.a, cut.b, cut.from, cut.until, cut.one_way});
  }
  for (const scenario::LinkSpec& link : scenario.radio.links) {
    config.links.push_back({link.a, link.b, link.one_way, link.from, link.until, link.latency,
                            link.loss, link.capacity});
  }
  config.seed = scenario.seed;
  return config;
}

/// Of the vehicles that a node plays.
std::vector<sim::ScheduledFault> onboard_faults(const Scenario& scenario, const std::string& node) {
  std::vector<sim::ScheduledFault> faults;
  for (const scenario::BreakSpec& one : scenario.faults.breaks) {
    const auto kind = one.device.empty() ? sim::FaultKind::kEngine : sim::FaultKind::kSensor;
    faults.push_back({one.at, {one.uav, kind, one.device}});
  }
  for (const scenario::SlowSpec& one : scenario.faults.slows) {
    sim::Fault fault{one.uav, sim::FaultKind::kSlow};
    fault.factor = one.factor;
    fault.lasts = one.lasts;
    faults.push_back({one.at, fault});
  }
  for (const scenario::AbortSpec& one : scenario.faults.aborts) {
    sim::Fault fault{one.uav, sim::FaultKind::kAbort};
    fault.type = one.type;
    fault.lasts = one.lasts;
    faults.push_back({one.at, fault});
  }
  for (const scenario::EnergySpec& one : scenario.faults.energies) {
    sim::Fault fault{one.uav, sim::FaultKind::kEnergy};
    fault.left = one.left;
    faults.push_back({one.at, fault});
  }
  std::erase_if(faults, [&](const sim::ScheduledFault& one) {
    const std::string& named = scenario.find_uav(one.fault.uav)->functional;
    return node != (named.empty() ? kSimulator : named);
  });
  std::stable_sort(faults.begin(), faults.end(),
                   [](const auto& a, const auto& b) { return a.at < b.at; });
  return faults;
}

}  // namespace

std::unique_ptr<node::Node> make_sim(const Scenario& scenario, const std::string& name) {
  return std::make_unique<sim::SimNode>(name, simulator_config(scenario, name),
                                        scenario_setup::roster_of(scenario),
                                        onboard_faults(scenario, name));
}

Diagnostics simulation_problems(const Scenario& scenario) {
  Diagnostics diagnostics;
  for (const std::string& problem : sim::problems_of(simulator_config(scenario, kSimulator))) {
    diagnostics.add({scenario.file, 0, 0, "", problem, "", ""});
  }
  return diagnostics;
}

}  // namespace skein::sim_setup
