// SPDX-License-Identifier: Apache-2.0
// Where high-level tasks take the UAV, for estimates without planning.
#pragma once

#include <memory>
#include <vector>

#include "skein/refiners/tour.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Alternative entry and exit points of the task, as gates of a tour: for a place the point over
/// it; for several places every ordered pair of them; for a zone the corners where a sweep may
/// begin, with its exit and its cost. Empty: the task has no place, or an unknown one. Cost: for a
/// zone, one sweep per corner.
std::vector<refiners::Gate> visits_of(const mission::HighLevelTask& task,
                                      std::shared_ptr<const Knowledge> knowledge,
                                      std::shared_ptr<const world::World> world, MissionTime at);

}  // namespace skein::supervisor
