// SPDX-License-Identifier: Apache-2.0
// Makes all nodes of a scenario, the same for both runtimes. Daemons, which run one node each, do
// not use this library.
#pragma once

#include <memory>
#include <string>

#include "skein/node/node.hpp"
#include "skein/node/virtual_runtime.hpp"
#include "skein/scenario/scenario.hpp"
#include "skein/scenario_setup/overrides.hpp"

namespace skein::assembly {

/// The node of a name of the roster: "ground", "sim", a functional layer or a UAV. Precondition: it
/// is one of these.
std::unique_ptr<node::Node> make_node(const scenario::Scenario& scenario, const std::string& name);
/// The same with the roster of the scenario, which the nodes of a process then share.
std::unique_ptr<node::Node> make_node(const scenario::Scenario& scenario, const std::string& name,
                                      const node::Roster& roster);

/// Checks of a scenario across its parts, beyond those of its reader (a start outside the terrain,
/// a cut between unknown nodes, a planning domain with errors): all problems at once. Impossible
/// missions are no problem: a UAV refuses them in flight.
Diagnostics check_assembly(const scenario::Scenario& scenario);

/// Reads a scenario file, applies the overrides and checks that its parts fit together.
Result<scenario::Scenario, Diagnostics> load_scenario(const std::string& path,
                                                      const scenario_setup::Overrides& overrides);

/// Configuration of the virtual runtime for the scenario.
node::VirtualConfig virtual_config(const scenario::Scenario& scenario);

}  // namespace skein::assembly
