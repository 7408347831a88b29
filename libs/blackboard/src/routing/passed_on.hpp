// SPDX-License-Identifier: Apache-2.0
// What a relay remembers of what it passes on.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard::routing {

/// Decides what is worth passing on, and keeps the last states for destinations that cannot be
/// reached at the moment. It promises nothing for events: their sender has them until the receiver
/// acknowledges, so a relay may die or restart at any time. What it refuses:
/// - a state or stream that is not newer than what went before it (DDS gives old ones again);
/// - an event that its sender is known to hold no more (a transport gives a whole history again
///   after each reconnection): heartbeats that come past say what it still holds.
class PassedOn {
 public:
  /// Whether this sample is to go on; then it counts as gone.
  bool admit(const wire::Sample& sample);
  /// A state, as it is to be written.
  void keep(const wire::Sample& state);
  /// For one destination, in an order that follows from the states alone.
  std::vector<wire::Sample> states_for(NodeNumber destination) const;

 private:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;  ///< origin, destination
  using Key = std::tuple<std::uint32_t, wire::Slot, std::uint32_t,
                         std::uint32_t>;                    ///< destination, slot, origin, instance
  using Version = std::pair<std::uint64_t, std::uint64_t>;  ///< incarnation, sequence
  bool is_held_by_its_sender(const wire::SampleHeader& header) const;

  std::map<Key, Version> newest_;
  std::map<Key, wire::Sample> states_;
  std::map<Pair, Version> held_from_;  ///< the oldest event that the origin holds
};

}  // namespace skein::blackboard::routing
