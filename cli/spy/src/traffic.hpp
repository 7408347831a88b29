// SPDX-License-Identifier: Apache-2.0
// Counts of received samples.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/time.hpp"

namespace skein::spy_tool {

struct Flow {
  wire::Slot slot = wire::Slot::kHeartbeat;
  std::uint32_t origin = 0;
  std::uint32_t destination = 0;  ///< 0: everybody
  std::uint64_t samples = 0;
  std::uint64_t malformed = 0;
  Duration first;  ///< steady
  Duration last;
  /// [1/s] between the first and the last; 0 if they came within half a second (a history).
  double rate() const;
};

/// Counts samples per slot, origin and destination.
class Traffic {
 public:
  void count(wire::Slot slot, std::uint32_t origin, std::uint32_t destination, bool malformed,
             Duration at);
  /// By slot, then origin, then destination.
  std::vector<Flow> flows() const;

 private:
  std::map<std::tuple<wire::Slot, std::uint32_t, std::uint32_t>, Flow> flows_;
};

}  // namespace skein::spy_tool
