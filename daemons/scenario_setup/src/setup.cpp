// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario_setup/setup.hpp"

#include <sstream>
#include <utility>

#include "skein/blackboard/channel.hpp"
#include "skein/blackboard/slot_table.hpp"

namespace skein::scenario_setup {

using scenario::Scenario;

namespace {

Result<blackboard::SlotTable, Diagnostics> slots_of(const Scenario& scenario) {
  return blackboard::read_slot_table(*scenario.slots, scenario.file,
                                     blackboard::SlotTable::shipped());
}

// An answer that is waited for must not expire on its way.
blackboard::SlotTable with_words_of(const team::Config& team, const blackboard::SlotTable& slots) {
  const Duration lifespan = team.limits.sale.answer_within;
  return slots.with_lifespan(wire::Slot::kTeamMessage, lifespan)
      .with_lifespan(wire::Slot::kTeamSale, lifespan);
}

}  // namespace

node::Roster roster_of(const Scenario& scenario) {
  node::Roster roster = node::Roster(scenario.uav_names(), scenario.functional_layers())
                            .relayed_by(scenario.radio.relays);
  if (scenario.slots) {
    if (auto slots = slots_of(scenario)) roster = roster.with_slots(std::move(*slots));
  }
  return scenario.team ? roster.with_slots(with_words_of(*scenario.team, roster.slots())) : roster;
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

std::vector<std::string> merging_uavs(const Scenario& scenario) {
  if (!scenario.separation || !scenario.separation->merge) return {};
  std::vector<std::string> flying;
  for (const scenario::UavSpec& uav : scenario.uavs)
    if (!uav.model.ground) flying.push_back(uav.name);
  return flying.size() > 1 ? flying : std::vector<std::string>();
}

Diagnostics radio_problems(const Scenario& scenario) {
  const double heartbeats = 8.0 * static_cast<double>(blackboard::heartbeat_bytes()) /
                            scenario.radio.heartbeat.to_seconds();
  Diagnostics diagnostics;
  if (scenario.slots) {
    if (const auto slots = slots_of(scenario); !slots) diagnostics.append(slots.error());
  }
  // Of a channel that heartbeats alone would fill there is nothing left.
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
