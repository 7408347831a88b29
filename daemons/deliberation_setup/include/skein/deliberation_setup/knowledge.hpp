// SPDX-License-Identifier: Apache-2.0
// Knowledge of a scenario's nodes for deliberation: world, planning domain, UAVs.
#pragma once

#include <memory>
#include <string>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/foundation/shared_list.hpp"
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

/// What deliberation knows at the start on every UAV of a scenario. The UAVs of a process share it:
/// its size grows with their number, so that all together would take the square of that. Immutable,
/// thread-safe.
class CommonKnowledge {
 public:
  /// Precondition: the scenario has planning without problems (planning_problems). Cost: that of
  /// vocabulary_of() and world_of().
  explicit CommonKnowledge(const scenario::Scenario& scenario);

  /// The knowledge of a UAV of the scenario. Cost: a copy of the domain's text and vocabulary.
  std::shared_ptr<const supervisor::Knowledge> of(const std::string& uav) const;
  std::shared_ptr<const world::World> world() const { return world_; }

 private:
  SharedList<std::string> team_;
  SharedList<supervisor::Partner> uavs_;
  supervisor::DomainText domain_;
  mission::Vocabulary vocabulary_;
  std::shared_ptr<const world::World> world_;
};

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
