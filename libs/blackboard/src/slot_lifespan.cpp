// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/slot_lifespan.hpp"

#include <algorithm>

#include "skein/blackboard/slot_table.hpp"

namespace skein::blackboard {

const SlotLifespans& default_lifespans() { return SlotTable::shipped().lifespans(); }

MissionTime expiry_of(wire::Slot slot, const SlotLifespans& lifespans, MissionTime sent,
                      MissionTime wanted) {
  const auto& lifespan = lifespans[static_cast<std::size_t>(slot)];
  return lifespan ? std::min(wanted, sent + *lifespan) : wanted;
}

}  // namespace skein::blackboard
