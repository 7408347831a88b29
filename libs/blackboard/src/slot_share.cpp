// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/slot_share.hpp"

#include "skein/blackboard/slot_table.hpp"

namespace skein::blackboard {

const SlotShares& default_shares() { return SlotTable::shipped().shares(); }

double reserved(const SlotShares& shares) {
  double sum = 0;
  for (const SlotShare& share : shares) sum += share.fraction;
  return sum;
}

}  // namespace skein::blackboard
