// SPDX-License-Identifier: Apache-2.0
// States and streams that wait for their turn on a channel.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "skein/blackboard/wire.hpp"

namespace skein::blackboard {

/// Of each (slot, instance) the newest value, and nothing older: what is shed is always what an
/// update has made useless. Within a slot the one that waits longest goes first; a newer value
/// takes the place of the older in that order. Memory: one value for each (slot, instance).
class WaitingValues {
 public:
  /// Gives true if an older value was shed for it.
  bool put(wire::Sample value);
  bool empty() const { return values_.empty(); }
  /// The next of a slot; null if none waits. Valid until the next call of anything else.
  const wire::Sample* first(wire::Slot slot) const;
  void drop_first(wire::Slot slot);
  /// All of a class, in the order of slots, oldest first; they wait no more.
  std::vector<wire::Sample> take(wire::SlotClass which);

 private:
  /// Origin, destination, instance: a relay's channel carries values of several nodes.
  using Instance = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
  using Key = std::pair<wire::Slot, Instance>;
  std::map<Key, wire::Sample> values_;
  std::map<wire::Slot, std::deque<Instance>> order_;  ///< instances
};

}  // namespace skein::blackboard
