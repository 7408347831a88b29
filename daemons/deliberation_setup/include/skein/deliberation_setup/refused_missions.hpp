// SPDX-License-Identifier: Apache-2.0
// What in a scenario is no error, and yet not what its author will have meant.
#pragma once

#include "skein/foundation/diagnostics.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::deliberation_setup {

/// The reasons for which the ground station will refuse missions of the script for single UAVs,
/// whatever happens until then, each at its task: unknown tasks, places, zones, devices and UAVs,
/// arguments of another number or kind, a use that no device of the vehicle serves, times that
/// contradict each other or have passed, a UAV that never deliberates. A scenario may mean them to
/// be refused, so they are no errors. Nothing if it has no planning or its domain has errors.
/// Cost: that of vocabulary_of(), and linear in the script.
Diagnostics refused_missions(const scenario::Scenario& scenario);

/// What is suspicious in the planning domain (supervisor::warnings_of); nothing without planning.
Diagnostics domain_warnings(const scenario::Scenario& scenario);

}  // namespace skein::deliberation_setup
