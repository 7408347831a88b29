// SPDX-License-Identifier: Apache-2.0
// Where high-level tasks take the UAV, for who would estimate without planning.
#pragma once

#include <memory>
#include <vector>

#include "skein/refiners/tour.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Ways of visiting what the task is about, as tours have them: the point over a place; of several
/// places every pair of them; of a zone the corners where a sweep may begin, with what that takes.
/// Empty: it has no place, or one that nobody knows. Cost: of a zone, a sweep each corner.
std::vector<refiners::Gate> visits_of(const mission::HighLevelTask& task,
                                      std::shared_ptr<const Knowledge> knowledge,
                                      std::shared_ptr<const world::World> world, MissionTime at);

}  // namespace skein::supervisor
