// SPDX-License-Identifier: Apache-2.0
#include "skein/assembly/assembly.hpp"

#include <algorithm>
#include <sstream>

#include "skein/assembly/knowledge.hpp"
#include "skein/blackboard/slot_table.hpp"
#include "skein/ddn/ddn_node.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/ground/ground_node.hpp"
#include "skein/interaction/model_hash.hpp"
#include "skein/scenario/operator_request.hpp"
#include "skein/sim_node/sim_node.hpp"

namespace skein::assembly {

namespace {

using scenario::Scenario;
using scenario::UavSpec;

/// How long a partner is taken to wait at a rendezvous; it says so again at half of this.
constexpr Duration kSyncValidity = Duration::milliseconds(30'000);
constexpr const char* kSimulator = "sim";
constexpr double kHomeAltitude = 40;  ///< [m] above the ground at the start, on the way home

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

ground_station::MissionKnowledge mission_knowledge(const Scenario& scenario) {
  ground_station::MissionKnowledge knowledge;
  if (scenario.planning) knowledge.vocabulary = vocabulary_of(scenario).value();
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
  for (const UavSpec& uav : scenario.uavs) {
    decision_node::Config& config = played.emplace_back();
    config.uav = uav.name;
    config.others = scenario.uav_names();
    std::erase(config.others, uav.name);
    config.knowledge = std::make_shared<supervisor::Knowledge>(knowledge_of(scenario, uav));
    config.world = std::make_shared<world::World>(world_of(scenario).value());
    config.interaction = scenario.interaction;
  }
  return played;
}

std::unique_ptr<node::Node> make_ground(const Scenario& scenario) {
  ground_station::GroundConfig config;
  const ddn::DdnConfig defaults;
  for (const UavSpec& uav : scenario.uavs) {
    ground_station::GroundUav one{uav.name, uav.degree, {}};
    one.executive.name = uav.name;
    one.executive.functional_timeout = defaults.functional_timeout;
    one.executive.sync_validity = kSyncValidity;
    config.uavs.push_back(std::move(one));
  }
  config.script = scenario.ground.script;
  config.pps = scenario.ground.pps;
  config.objects = scenario.ground.objects;
  config.dates = dates_by_ground(scenario);
  config.missions = mission_knowledge(scenario);
  return std::make_unique<ground::GroundNode>(config, world::Terrain(scenario.world.terrain),
                                              roster_of(scenario), request_reader(scenario),
                                              scenario.team, played_by_ground(scenario));
}

std::vector<std::string> names_of_flying(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const UavSpec& uav : scenario.uavs)
    if (!uav.model.ground) names.push_back(uav.name);
  return names;
}

std::unique_ptr<node::Node> make_ddn(const Scenario& scenario, const UavSpec& uav) {
  ddn::DdnConfig config;
  config.uav = uav.name;
  config.degree = uav.degree;
  config.contact_policy = static_cast<decision_node::ContactPolicy>(uav.contact_loss.policy);
  config.contact_after = uav.contact_loss.after;
  config.sync_validity = kSyncValidity;
  const world::Terrain terrain(scenario.world.terrain);
  config.drives = uav.model.ground.has_value();
  config.home = {uav.start.x(), uav.start.y(),
                 terrain.elevation(uav.start.x(), uav.start.y()) + kHomeAltitude};
  if (scenario.team && scenario.team->roster.number_of(uav.name)) config.team = scenario.team;
  if (scenario.planning) {
    const auto& first_ids = scenario.planning->first_ids;
    const auto first = first_ids.find(uav.name);
    config.knowledge = std::make_shared<supervisor::Knowledge>(knowledge_of(scenario, uav));
    config.world = std::make_shared<world::World>(world_of(scenario).value());
    config.interaction = scenario.interaction;
    config.horizon = scenario.planning->horizon;
    config.consistency = scenario.planning->consistency;
    if (first != first_ids.end()) config.first_task = first->second;
  }
  if (scenario.separation && scenario.separation->merge && !config.drives) {
    config.merging = {names_of_flying(scenario), uav.model, scenario.world.wind,
                      std::make_shared<world::Terrain>(terrain), scenario.world.volumes};
  }
  return std::make_unique<ddn::DdnNode>(config, roster_of(scenario));
}

Result<blackboard::SlotTable, Diagnostics> slots_of(const Scenario& scenario) {
  return blackboard::read_slot_table(*scenario.slots, scenario.file,
                                     blackboard::SlotTable::shipped());
}

/// Errors of the scenario's own table of slots, with their places.
Diagnostics slot_problems(const Scenario& scenario) {
  if (!scenario.slots) return {};
  const auto slots = slots_of(scenario);
  return slots ? Diagnostics() : slots.error();
}

/// Of a channel that heartbeats alone would fill there is nothing left.
Diagnostics radio_problems(const Scenario& scenario) {
  const double heartbeats = 8.0 * static_cast<double>(blackboard::heartbeat_bytes()) /
                            scenario.radio.heartbeat.to_seconds();
  Diagnostics diagnostics;
  const auto check = [&](double capacity, const std::string& of) {
    if (capacity <= 0 || capacity >= 2 * heartbeats) return;
    std::ostringstream text;
    text << "radio: heartbeats take " << heartbeats << " bit/s, more than half of the " << capacity
         << " bit/s of " << of;
    diagnostics.add({scenario.file, 0, 0, "", text.str(),
                     "a greater capacity, or heartbeats that come less often", ""});
  };
  check(scenario.radio.model.capacity, "the radio");
  for (const scenario::LinkSpec& link : scenario.radio.links)
    check(link.capacity.value_or(0), "the link between " + link.a + " and " + link.b);
  return diagnostics;
}

}  // namespace

node::Roster roster_of(const Scenario& scenario) {
  node::Roster roster = node::Roster(scenario.uav_names(), scenario.functional_layers())
                            .relayed_by(scenario.radio.relays);
  if (!scenario.slots) return roster;
  auto slots = slots_of(scenario);
  return slots ? roster.with_slots(std::move(*slots)) : roster;
}

std::unique_ptr<node::Node> make_node(const Scenario& scenario, const std::string& name) {
  if (name == "ground") return make_ground(scenario);
  if (const UavSpec* uav = scenario.find_uav(name)) return make_ddn(scenario, *uav);
  SKEIN_EXPECTS(roster_of(scenario).find(name) != nullptr);
  return std::make_unique<sim::SimNode>(name, simulator_config(scenario, name), roster_of(scenario),
                                        onboard_faults(scenario, name));
}

Diagnostics check_assembly(const Scenario& scenario) {
  Diagnostics diagnostics;
  for (const std::string& problem : sim::problems_of(simulator_config(scenario, kSimulator))) {
    diagnostics.add({scenario.file, 0, 0, "", problem, "", ""});
  }
  diagnostics.append(radio_problems(scenario));
  diagnostics.append(slot_problems(scenario));
  diagnostics.append(planning_problems(scenario));
  diagnostics.append(joint_task_problems(scenario));
  return diagnostics;
}

node::RadioCapacity capacity_of(const Scenario& scenario) {
  node::RadioCapacity capacity{scenario.radio.model.capacity};
  for (const scenario::LinkSpec& link : scenario.radio.links) {
    const bool always = link.from <= MissionTime() && link.until >= scenario.duration_limit;
    if (!link.capacity || !always) continue;
    capacity.of_links[{link.a, link.b}] = *link.capacity;
    if (!link.one_way) capacity.of_links[{link.b, link.a}] = *link.capacity;
  }
  return capacity;
}

node::VirtualConfig virtual_config(const Scenario& scenario) {
  node::VirtualConfig config;
  config.seed = scenario.seed;
  config.time_limit = scenario.duration_limit;
  config.heartbeat_period = scenario.radio.heartbeat;
  config.capacity = capacity_of(scenario);
  config.silent_cuts = scenario.radio.silent;
  for (const scenario::KillSpec& kill : scenario.faults.kills) {
    std::optional<MissionTime> restart;
    if (kill.restart_after) restart = kill.at + *kill.restart_after;
    config.crashes.push_back({kill.at, kill.node, restart, !kill.forgets});
  }
  return config;
}

}  // namespace skein::assembly
