// SPDX-License-Identifier: Apache-2.0
// What the nodes of a scenario know for deliberation: world, planning domain, what each UAV is.
#pragma once

#include <memory>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/scenario/scenario.hpp"
#include "skein/supervisor/planning.hpp"
#include "skein/world/world.hpp"

namespace skein::deliberation_setup {

/// The world as refiners are told of it at the start, or why there is none.
/// Precondition: the scenario has planning. Cost: the airspace's grid and the ground's state.
Result<world::World, Diagnostics> world_of(const scenario::Scenario& scenario);

/// What may be asked of UAVs, or every error of the planning domain with its file and line.
/// Precondition: the scenario has planning.
Result<mission::Vocabulary, Diagnostics> vocabulary_of(const scenario::Scenario& scenario);

/// What the UAV's deliberation knows. Precondition: the scenario has planning, its domain no error.
supervisor::Knowledge knowledge_of(const scenario::Scenario& scenario,
                                   const scenario::UavSpec& uav);

/// Every reason why nobody can plan in the scenario: errors of the domain, an airspace without
/// extent or of too many voxels, a UAV at degree 4 where nothing is said of planning.
Diagnostics planning_problems(const scenario::Scenario& scenario);

/// Every reason why members of a joint task of the script cannot take part: no such UAV, the UAV
/// that is asked not among them, a degree that does not deliberate.
Diagnostics joint_task_problems(const scenario::Scenario& scenario);

}  // namespace skein::deliberation_setup
