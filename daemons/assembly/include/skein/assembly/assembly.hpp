// SPDX-License-Identifier: Apache-2.0
// From a scenario to the nodes that play it, the same for both runtimes.
#pragma once

#include <memory>
#include <string>

#include "skein/node/daemon.hpp"
#include "skein/node/roster.hpp"
#include "skein/node/virtual_runtime.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::assembly {

node::Roster roster_of(const scenario::Scenario& scenario);

/// The node of a name of the roster: "ground", "sim" or a UAV. Precondition: it is one of these.
std::unique_ptr<node::Node> make_node(const scenario::Scenario& scenario, const std::string& name);

/// What the reader of a scenario cannot see because it only shows when the parts meet (a start
/// outside the terrain, a cut between unknown nodes, a planning domain with errors): every problem
/// at once. Missions that make no sense are none: a UAV refuses them in flight.
Diagnostics check_assembly(const scenario::Scenario& scenario);

/// How the virtual runtime plays the scenario.
node::VirtualConfig virtual_config(const scenario::Scenario& scenario);

/// What the scenario says of its radio for all of its time.
node::RadioCapacity capacity_of(const scenario::Scenario& scenario);

}  // namespace skein::assembly
