// SPDX-License-Identifier: Apache-2.0
// Which air is closed in a scenario, and by what records of the log that begins and ends.
#include "reading.hpp"

namespace skein::scenario {

namespace {

using ground_station::Action;

Pattern record_of(const char* kind, const char* field, const std::string& name) {
  return {{{"kind", {std::string(kind)}}, {field, {name}}}};
}

// Calls use(action, pattern of the record that tells when it is carried out).
template <class Use>
void for_actions(const ground_station::Script& script, Use use) {
  for (const auto& step : script.steps) {
    for (const Action& action : step.actions) use(action, record_of("step", "name", step.name));
  }
  for (const auto& one : script.operators) {
    for (const Action& action : one.actions) use(action, record_of("operator", "does", one.does));
  }
}

}  // namespace

std::vector<ClosedAir> closed_air_of(const Scenario& scenario) {
  std::vector<ClosedAir> air;
  for (const world::Volume& volume : scenario.world.volumes) air.push_back({volume, {}, {}});
  for_actions(scenario.ground.script, [&](const Action& action, const Pattern& when) {
    if (const auto* close = std::get_if<ground_station::CloseAir>(&action)) {
      air.push_back({close->volume, when, {}});
    }
  });
  for_actions(scenario.ground.script, [&](const Action& action, const Pattern& when) {
    const auto* open = std::get_if<ground_station::OpenAir>(&action);
    if (open == nullptr) return;
    for (ClosedAir& one : air) {
      if (one.volume.name == open->name && !one.opened_by) one.opened_by = when;
    }
  });
  return air;
}

}  // namespace skein::scenario
