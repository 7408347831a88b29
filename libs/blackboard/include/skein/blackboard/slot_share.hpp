// SPDX-License-Identifier: Apache-2.0
// The shares of the slots in a channel of limited capacity.
#pragma once

#include <array>
#include <cstdint>

#include "skein/blackboard/wire.hpp"

namespace skein::blackboard {

/// The share of one slot in one channel.
struct SlotShare {
  double fraction = 0;  ///< of the capacity, reserved while the slot has something to send; [0, 1]
  std::uint8_t priority = 0;  ///< for capacity that is not reserved or not used; greater goes first
  bool operator==(const SlotShare&) const = default;
};

/// By slot, in the order of wire::Slot. The fractions of a channel must not add up to more than 1.
using SlotShares = std::array<SlotShare, wire::kSlotCount>;

/// The shares of SlotTable::shipped().
const SlotShares& default_shares();

/// Sum of the fractions.
double reserved(const SlotShares& shares);

}  // namespace skein::blackboard
