// SPDX-License-Identifier: Apache-2.0
// Makes the simulator node of a scenario.
#pragma once

#include <memory>
#include <string>

#include "skein/foundation/diagnostics.hpp"
#include "skein/node/node.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::sim_setup {

/// Makes the simulator ("sim"), or a functional layer that the scenario names, which simulates its
/// own vehicles only.
std::unique_ptr<node::Node> make_sim(const scenario::Scenario& scenario, const std::string& name);

/// All problems in the combination of world, vehicles and radio (a start outside the terrain, a cut
/// between unknown nodes).
Diagnostics simulation_problems(const scenario::Scenario& scenario);

}  // namespace skein::sim_setup
