// SPDX-License-Identifier: Apache-2.0
// Knowledge of a scenario's nodes for deliberation: world, planning domain, UAVs.
#pragma once

#include <memory>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/scenario/scenario.hpp"
#include "skein/supervisor/planning.hpp"
#include "skein/world/world.hpp"

namespace skein::deliberation_setup {

/// The initial world model of the refiners, or its errors.
/// Precondition: the scenario has planning. Cost: the airspace's grid and the ground's state.
Result<world::World, Diagnostics> world_of(const scenario::Scenario& scenario);

/// The high-level tasks of the planning domain, or all its errors with file and line.
/// Precondition: the scenario has planning.
Result<mission::Vocabulary, Diagnostics> vocabulary_of(const scenario::Scenario& scenario);

/// The knowledge of a UAV's deliberation. Precondition: the scenario has planning, and its domain
/// has no errors.
supervisor::Knowledge knowledge_of(const scenario::Scenario& scenario,
                                   const scenario::UavSpec& uav);

/// All problems of planning in the scenario: errors of the domain, an airspace without extent or
/// with too many voxels, a UAV at degree 4 in a scenario without planning.
Diagnostics planning_problems(const scenario::Scenario& scenario);

/// All problems of the members of joint tasks in the script: an unknown UAV, the addressed UAV not
/// among the members, a degree without deliberation.
Diagnostics joint_task_problems(const scenario::Scenario& scenario);

/// Tasks of global missions in the script that contradict each other in time or for want of
/// members, whoever does them, each with the constraints of the conflict (see
/// team::conflicts_of). Nothing if the scenario has no team or its domain has errors.
Diagnostics global_mission_problems(const scenario::Scenario& scenario);

}  // namespace skein::deliberation_setup
