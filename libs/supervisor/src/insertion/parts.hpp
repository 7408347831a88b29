// SPDX-License-Identifier: Apache-2.0
// A mapping flown in two parts, so that other tasks fit between them.
#pragma once

#include "insertion/blocks.hpp"

namespace skein::supervisor {

/// The first part of the mapping, with that share of its lanes. It has the mapping's start_after
/// and its bounds on starts after goals; the mapping comes after it, so that its latest dates bound
/// both.
mission::HighLevelTask part_of(const mission::HighLevelTask& mapping, mission::GoalId id,
                               double share);
/// The free mappings of which no part is in the order yet.
Goals whole_mappings(const Movable& movable);
/// `movable` with the part inserted right before its mapping.
Movable with_part(const Movable& movable, const mission::HighLevelTask& part);
/// The blocks in their order, except that the mapping of the part moves behind the last block after
/// the part that has dates.
Blocks rest_behind_dates(const Blocks& blocks, const mission::HighLevelTask& part);
/// Whether another task comes between the part and its mapping.
bool parts_stand_apart(const Goals& order, const mission::HighLevelTask& part);

}  // namespace skein::supervisor
