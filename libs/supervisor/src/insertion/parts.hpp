// SPDX-License-Identifier: Apache-2.0
// A mapping flown in two parts, so that something else has its place between them.
#pragma once

#include "insertion/blocks.hpp"

namespace skein::supervisor {

/// The first part of the mapping, with that share of its lanes. It may begin when the mapping may;
/// the mapping comes after it, so that its latest dates are that one's too.
mission::HighLevelTask part_of(const mission::HighLevelTask& mapping, mission::GoalId id,
                               double share);
/// Of what is free to move, the mappings of which no part stands in the order yet.
Goals whole_mappings(const Movable& movable);
/// The same with the part right before its mapping.
Movable with_part(const Movable& movable, const mission::HighLevelTask& part);
/// The blocks in their order, but what the part leaves behind the last of those behind it that have
/// dates.
Blocks rest_behind_dates(const Blocks& blocks, const mission::HighLevelTask& part);
/// Something stands between the part and its mapping, behind it.
bool parts_stand_apart(const Goals& order, const mission::HighLevelTask& part);

}  // namespace skein::supervisor
