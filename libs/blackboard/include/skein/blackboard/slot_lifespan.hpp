// SPDX-License-Identifier: Apache-2.0
// How long what is said in a slot counts.
#pragma once

#include <array>
#include <optional>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// By slot, in the order of wire::Slot: the mission time after which an event must not be handled
/// any more, counted from when it is sent; none: as long as its sender says. States and streams
/// have none, since a newer value takes their place.
using SlotLifespans = std::array<std::optional<Duration>, wire::kSlotCount>;

/// Those of SlotTable::shipped().
const SlotLifespans& default_lifespans();

/// When an event that is sent at `sent` expires, whose sender says `wanted`.
MissionTime expiry_of(wire::Slot slot, const SlotLifespans& lifespans, MissionTime sent,
                      MissionTime wanted);

}  // namespace skein::blackboard
