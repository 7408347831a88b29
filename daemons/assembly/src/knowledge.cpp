// SPDX-License-Identifier: Apache-2.0
#include "skein/assembly/knowledge.hpp"

#include <utility>

#include "skein/foundation/contract.hpp"
#include "skein/world/world_builder.hpp"

namespace skein::assembly {

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

Result<mission::Vocabulary, Diagnostics> vocabulary_of(const Scenario& scenario) {
  SKEIN_EXPECTS(scenario.planning.has_value());
  return supervisor::vocabulary_of(domain_of(scenario));
}

namespace {

supervisor::Partner partner_of(const Scenario& scenario, const UavSpec& uav) {
  const world::Terrain terrain(scenario.world.terrain);
  const auto& altitudes = scenario.planning->altitudes;
  const auto own = altitudes.find(uav.name);
  return {uav.name,
          uav.model,
          {uav.start.x(), uav.start.y(), terrain.elevation(uav.start.x(), uav.start.y())},
          own != altitudes.end() ? own->second : scenario.planning->altitude};
}

}  // namespace

supervisor::Knowledge knowledge_of(const Scenario& scenario, const UavSpec& uav) {
  auto vocabulary = vocabulary_of(scenario);
  SKEIN_EXPECTS(vocabulary.has_value());
  supervisor::Knowledge knowledge;
  for (const UavSpec& one : scenario.uavs) {
    supervisor::Partner partner = partner_of(scenario, one);
    if (one.name != uav.name) {
      knowledge.partners.push_back(std::move(partner));
      continue;
    }
    knowledge.uav = partner.uav;
    knowledge.vehicle = std::move(partner.vehicle);
    knowledge.home = partner.home;
    knowledge.altitude = partner.altitude;
  }
  knowledge.team = scenario.uav_names();
  knowledge.domain = domain_of(scenario);
  knowledge.vocabulary = std::move(*vocabulary);
  return knowledge;
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
                     "degree 4 of " + uav.name + ": nothing is said of planning on board",
                     "planning: {domain: FILE}", ""});
  }
  return diagnostics;
}

}  // namespace skein::assembly
