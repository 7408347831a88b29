// SPDX-License-Identifier: Apache-2.0
// From a scenario to the decision node of one of its UAVs.
#pragma once

#include <memory>

#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::ddn_setup {

/// Precondition: the scenario has no problem of planning (knowledge.hpp).
std::unique_ptr<node::Node> make_ddn(const scenario::Scenario& scenario,
                                     const scenario::UavSpec& uav);
/// The same with the roster of the scenario, so that the nodes of a process share one.
std::unique_ptr<node::Node> make_ddn(const scenario::Scenario& scenario,
                                     const scenario::UavSpec& uav, const node::Roster& roster);

}  // namespace skein::ddn_setup
