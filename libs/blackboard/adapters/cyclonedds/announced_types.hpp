// SPDX-License-Identifier: Apache-2.0
// Types that are announced to programs that do not have them.
#pragma once

#include <dds/dds.h>

#include <set>

#include "skein/blackboard/wire.hpp"

namespace skein::blackboard::cyclonedds {

/// Announces the types of `slots` for as long as the participant lives: for each a writer of its
/// topic that says nothing, has the XTypes description of the type, and matches no reader: in the
/// partition "types", of exclusive ownership, and best effort. Endpoints that carry samples have no
/// description, so that what others announce of their types decides nothing, and cannot crash
/// Cyclone DDS here, whose comparison of types writes past its memory (docs/decisions/0099).
/// Negative: the reason why a writer was not made.
dds_return_t announce_types(dds_entity_t participant, const std::set<wire::Slot>& slots);

}  // namespace skein::blackboard::cyclonedds
