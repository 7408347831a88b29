// SPDX-License-Identifier: Apache-2.0
// What every daemon takes from a scenario, whichever node it runs.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/time.hpp"
#include "skein/node/host.hpp"
#include "skein/node/roster.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::scenario_setup {

/// How long a partner is taken to wait at a rendezvous; it says so again at half of this.
inline constexpr Duration kSyncValidity = Duration::milliseconds(30'000);

/// With the scenario's own table of slots, if it has one that is right.
node::Roster roster_of(const scenario::Scenario& scenario);

/// Those that merge their ways, in the order of the roster: all that fly, if the scenario asks for
/// it and they are several; else nobody.
std::vector<std::string> merging_uavs(const scenario::Scenario& scenario);

/// What the scenario says of its radio for all of its time.
node::RadioCapacity capacity_of(const scenario::Scenario& scenario);

/// Every channel of which heartbeats alone would take more than half, and what is wrong with the
/// scenario's own table of slots, with its place.
Diagnostics radio_problems(const scenario::Scenario& scenario);

}  // namespace skein::scenario_setup
