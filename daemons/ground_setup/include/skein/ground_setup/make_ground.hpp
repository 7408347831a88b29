// SPDX-License-Identifier: Apache-2.0
// From a scenario to its ground station.
#pragma once

#include <memory>

#include "skein/node/node.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::ground_setup {

/// Precondition: the scenario has no problem of planning (skein/deliberation_setup/knowledge.hpp).
std::unique_ptr<node::Node> make_ground(const scenario::Scenario& scenario);

}  // namespace skein::ground_setup
