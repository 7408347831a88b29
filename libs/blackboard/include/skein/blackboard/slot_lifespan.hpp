// SPDX-License-Identifier: Apache-2.0
// The lifespans of events, by slot.
#pragma once

#include <array>
#include <optional>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// By slot, in the order of wire::Slot: the span of mission time after sending in which an event
/// may be handled; none: only its sender limits it (SendOptions::expires). States and streams have
/// no lifespan, since newer values replace them.
using SlotLifespans = std::array<std::optional<Duration>, wire::kSlotCount>;

/// The lifespans of SlotTable::shipped().
const SlotLifespans& default_lifespans();

/// The instant at which an event expires that is sent at `sent` with SendOptions::expires `wanted`.
MissionTime expiry_of(wire::Slot slot, const SlotLifespans& lifespans, MissionTime sent,
                      MissionTime wanted);

}  // namespace skein::blackboard
