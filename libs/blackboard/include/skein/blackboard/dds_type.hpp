// SPDX-License-Identifier: Apache-2.0
// The DDS types of slots.
#pragma once

#include <string>

#include "skein/blackboard/wire.hpp"

namespace skein::blackboard {

/// The name of the slot's type in idl/: "skein::idl::Telemetry".
inline std::string dds_type_of(wire::Slot slot) {
  return "skein::idl::" + std::string(wire::slot_name(slot));
}

/// The partition of writers that only announce the types of their topics (NetworkConfig::types).
inline constexpr const char* kTypesPartition = "types";

}  // namespace skein::blackboard
