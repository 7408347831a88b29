// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario_setup/setup.hpp"

#include <sstream>

#include "skein/blackboard/channel.hpp"

namespace skein::scenario_setup {

using scenario::Scenario;

node::Roster roster_of(const Scenario& scenario) {
  return node::Roster(scenario.uav_names(), scenario.functional_layers())
      .relayed_by(scenario.radio.relays);
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

}  // namespace skein::scenario_setup
