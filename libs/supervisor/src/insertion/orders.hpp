// SPDX-License-Identifier: Apache-2.0
// The orders of high-level tasks by placement. Source: spec 6.2 (1).
#pragma once

#include "insertion/blocks.hpp"
#include "insertion/sketch.hpp"

namespace skein::supervisor {

/// (b) The merge of planned and added blocks, each list in its order, with the least violation of
/// absolute constraints and, among those, the earliest end, by the times of the sketch. Ties put
/// planned blocks first. Exact for these times. Cost: O(planned × added).
Blocks merge_in_time(const Movable& movable, const Sketch& sketch, const PlanningRequest& base);

/// The same for one list alone: blocks with constraints, sorted by the date that bounds them, are
/// merged with those without; shared blocks keep their rank.
Blocks urgent_in_time(const Movable& movable, const Sketch& sketch, const PlanningRequest& base);

/// (c) All blocks in the order of a shortest tour over their places, from the UAV's position, to
/// its landing place if it is to land. Blocks without a place, and shared ones, keep their rank. If
/// no tour can be flown, distances are straight lines. Optimal for up to twelve places, apart from
/// turns. Cost: a tour (refiners/tour.hpp).
Blocks tour_over(const Movable& movable, const PlanningRequest& base);

/// Whether any of the goals has an absolute time constraint.
bool bounded_in_time(const Goals& goals);

}  // namespace skein::supervisor
