// SPDX-License-Identifier: Apache-2.0
// From a scenario to the decision node of one of its UAVs.
#pragma once

#include <memory>

#include "skein/deliberation_setup/knowledge.hpp"
#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::ddn_setup {

/// Precondition: the scenario has no problem of planning (knowledge.hpp).
std::unique_ptr<node::Node> make_ddn(const scenario::Scenario& scenario,
                                     const scenario::UavSpec& uav);
/// The same with what the nodes of a process share: the roster of the scenario, and what all know
/// of planning; null: nothing is said of planning.
std::unique_ptr<node::Node> make_ddn(const scenario::Scenario& scenario,
                                     const scenario::UavSpec& uav, const node::Roster& roster,
                                     const deliberation_setup::CommonKnowledge* knowledge);

}  // namespace skein::ddn_setup
