// SPDX-License-Identifier: Apache-2.0
// Configuration from a scenario that every daemon needs, whichever node it runs.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/time.hpp"
#include "skein/node/host.hpp"
#include "skein/node/roster.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::scenario_setup {

/// Validity of a partner's message that it waits at a rendezvous; it is repeated after half of
/// this.
inline constexpr Duration kSyncValidity = Duration::milliseconds(30'000);

/// The roster, with the scenario's table of slots, if it has a valid one.
node::Roster roster_of(const scenario::Scenario& scenario);

/// The UAVs that use plan merging, in the order of the roster: all that fly, if the scenario asks
/// for it and there are several; else none.
std::vector<std::string> merging_uavs(const scenario::Scenario& scenario);

/// The radio capacity of the scenario, constant over the mission.
node::RadioCapacity capacity_of(const scenario::Scenario& scenario);

/// Every channel of which heartbeats alone would take more than half, and what is wrong with the
/// scenario's own table of slots, with its place.
Diagnostics radio_problems(const scenario::Scenario& scenario);

}  // namespace skein::scenario_setup
