// SPDX-License-Identifier: Apache-2.0
// Queue of states and streams for a channel of limited capacity.
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

/// Keeps only the newest value of each (slot, instance): a value is dropped only when a newer one
/// replaces it. Within a slot the longest waiting instance goes first; a newer value takes the
/// position of the one that it replaces. Memory: one value for each (slot, instance).
class WaitingValues {
 public:
  /// True if `value` replaced an older one.
  bool put(wire::Sample value);
  /// Removes the value of the same slot and instance; false if there is none.
  bool drop(const wire::Sample& like);
  bool has(const wire::Sample& like) const { return values_.contains(key_of(like)); }
  /// Whether the one takes the place of the other.
  static bool are_alike(const wire::Sample& one, const wire::Sample& other) {
    return key_of(one) == key_of(other);
  }
  bool empty() const { return values_.empty(); }
  /// The next value of a slot; null if none waits. Valid until the next call of another function.
  const wire::Sample* first(wire::Slot slot) const;
  void drop_first(wire::Slot slot);
  /// Removes and returns all values of a class, in the order of slots, oldest first.
  std::vector<wire::Sample> take(wire::SlotClass which);

 private:
  /// Origin, destination, instance: a relay's channel carries values of several nodes.
  using Instance = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
  using Key = std::pair<wire::Slot, Instance>;
  static Key key_of(const wire::Sample& value);

  std::map<Key, wire::Sample> values_;
  std::map<wire::Slot, std::deque<Instance>> order_;  ///< instances
};

}  // namespace skein::blackboard
