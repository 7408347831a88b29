// SPDX-License-Identifier: Apache-2.0
// The slot by which the ground station tells where objects were seen.
// Written by idl/generate_wire.py from idl/state.idl: change that, and run it.
// clang-format off
#pragma once

#include <cstdint>
#include <string>

#include "skein/blackboard/wire_common.hpp"

namespace skein::wire {

/// An object that sensors follow: where it was when it was seen last. The instance is by its name.
struct SeenObject {
  SampleHeader header;
  std::string name;
  std::string kind;
  Vector3 at;  ///< [m]
  double spread = 0;  ///< standard deviation of the place, per axis [m]
  std::int64_t seen = 0;  ///< [ns]
  bool operator==(const SeenObject&) const = default;
};
SKEIN_WIRE_FIELDS(SeenObject, header, name, kind, at, spread, seen)

}  // namespace skein::wire
