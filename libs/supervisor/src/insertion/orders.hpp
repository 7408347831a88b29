// SPDX-License-Identifier: Apache-2.0
// The orders that placements give. Source: spec 6.2 (1).
#pragma once

#include "insertion/blocks.hpp"
#include "insertion/sketch.hpp"

namespace skein::supervisor {

/// (b) The merge of the planned and the added blocks, each in its order, that is least late by the
/// absolute constraints, and of those the first to end; by the sketch's times. Where it makes no
/// difference what was planned goes first. Exact for these times. Cost: O(planned × added).
Blocks merge_in_time(const Movable& movable, const Sketch& sketch, const PlanningRequest& base);

/// Likewise for one list alone: the blocks that have constraints, by the date that bounds them,
/// among those that have none; shared ones keep their turn.
Blocks urgent_in_time(const Movable& movable, const Sketch& sketch, const PlanningRequest& base);

/// (c) All blocks in the order of a tour over their places, from where the UAV is, to its landing
/// place when it is to land. Blocks without a place, and shared ones, keep their turn.
/// Where no tour can be flown the blocks are ordered by straight flights. Exact for up to twelve
/// places, turns apart. Cost: a tour (refiners/tour.hpp).
Blocks tour_over(const Movable& movable, const PlanningRequest& base);

/// True when any of them has an absolute constraint.
bool bounded_in_time(const Goals& goals);

}  // namespace skein::supervisor
