// SPDX-License-Identifier: Apache-2.0
// The memory of a relay about the samples that it forwards.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard::routing {

/// Decides which samples are forwarded, and keeps the last states for destinations that cannot be
/// reached at the moment. Events are not kept: their sender holds them until the receiver
/// acknowledges, so a relay may die or restart at any time. Not forwarded are:
/// - a state or stream that is not newer than the one before (DDS gives old ones again);
/// - an event that its sender does not hold any more, according to the heartbeats that were
///   forwarded (a transport gives its whole history again after each reconnection).
class PassedOn {
 public:
  /// Whether this sample is to be forwarded; if so, it counts as forwarded.
  bool admit(const wire::Sample& sample);
  /// Keeps a state as it is forwarded.
  void keep(const wire::Sample& state);
  /// What this origin said last counts no more: it is another process from now on.
  void forget(std::uint32_t origin);
  /// The states for one destination, in an order that depends on the states only.
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
