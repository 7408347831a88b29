// SPDX-License-Identifier: Apache-2.0
// The XTypes description of a slot's type.
#pragma once

#include <cstdint>
#include <span>

#include "skein/blackboard/wire.hpp"

namespace skein::blackboard::cyclonedds {

/// Serialised, as idlc writes it. Source: XTypes 1.3, 7.6.3.2 (TypeInformation), 7.3.4 (type
/// objects).
struct TypeDescription {
  std::span<const std::uint8_t> information;  ///< identifiers of the type and of those it needs
  std::span<const std::uint8_t> mapping;      ///< identifiers to type objects
};

/// The fields of the header stand first in the type, which has no base: Cyclone DDS 0.10.2 crashes
/// on keys in a base (docs/decisions/0099). Valid for ever.
TypeDescription describe(wire::Slot slot);

}  // namespace skein::blackboard::cyclonedds
