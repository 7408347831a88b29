// SPDX-License-Identifier: Apache-2.0
// The slot by which nodes tell each other whom they hear.
// Written by idl/generate_wire.py from idl/state.idl: change that, and run it.
// clang-format off
#pragma once

#include <cstdint>
#include <vector>

#include "skein/blackboard/wire_common.hpp"

namespace skein::wire {

/// A node that is heard directly.
struct Neighbour {
  std::uint32_t node = 0;
  bool steady = false;  ///< false: it was lost and has come back only just now
  bool operator==(const Neighbour&) const = default;
};
SKEIN_WIRE_FIELDS(Neighbour, node, steady)

/// Whom its origin hears over radio, for everybody: relays pass it on, and routes follow from it.
/// Instance 0, destination 0. Source: spec 1.3 (re-routing).
struct Neighbours {
  SampleHeader header;
  std::vector<Neighbour> hears;  ///< by number
  bool operator==(const Neighbours&) const = default;
};
SKEIN_WIRE_FIELDS(Neighbours, header, hears)

}  // namespace skein::wire
