// SPDX-License-Identifier: Apache-2.0
// What each slot gets of a channel that cannot carry everything.
#pragma once

#include <array>
#include <cstdint>

#include "skein/blackboard/wire.hpp"

namespace skein::blackboard {

/// Of one slot on one channel.
struct SlotShare {
  double fraction =
      0;  ///< of the channel, reserved whenever the slot has something to send; [0, 1]
  std::uint8_t priority = 0;  ///< who goes first on what nobody has reserved; greater first
  bool operator==(const SlotShare&) const = default;
};

/// By slot, in the order of wire::Slot. The fractions of a channel must not add up to more than 1.
using SlotShares = std::array<SlotShare, wire::kSlotCount>;

/// Those of SlotTable::shipped().
const SlotShares& default_shares();

/// Sum of the fractions.
double reserved(const SlotShares& shares);

}  // namespace skein::blackboard
