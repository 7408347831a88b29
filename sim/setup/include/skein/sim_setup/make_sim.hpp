// SPDX-License-Identifier: Apache-2.0
// From a scenario to the node that simulates its world and vehicles.
#pragma once

#include <memory>
#include <string>

#include "skein/foundation/diagnostics.hpp"
#include "skein/node/node.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::sim_setup {

/// The simulator ("sim"), or a functional layer that the scenario names, which plays its own
/// vehicles only.
std::unique_ptr<node::Node> make_sim(const scenario::Scenario& scenario, const std::string& name);

/// What only shows when the world meets the vehicles and the radio (a start outside the terrain, a
/// cut between unknown nodes): every problem at once.
Diagnostics simulation_problems(const scenario::Scenario& scenario);

}  // namespace skein::sim_setup
