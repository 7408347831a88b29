// SPDX-License-Identifier: Apache-2.0
// Tasks of a global mission that contradict each other.
#pragma once

#include <string>
#include <vector>

#include "skein/team/global_mission.hpp"

namespace skein::team {

struct Conflict {
  mission::GoalId task;  ///< one of those that contradict each other
  std::string sentence;  ///< all of them, and every constraint that takes part [s]
};

/// The conflicts of a mission, whoever does it: windows, durations and precedences that leave no
/// dates; more members than may do a task; two tasks that need the same UAV and fit in neither
/// order. Nothing begins before `now`; ways take no time. `uavs` are those of the team.
/// Precondition: ids are in the auction's range. Cost: the square of the tasks.
std::vector<Conflict> conflicts_of(const GlobalMission& mission, const Roster& roster,
                                   const mission::Vocabulary& vocabulary,
                                   const std::vector<std::string>& uavs, MissionTime now);

}  // namespace skein::team
