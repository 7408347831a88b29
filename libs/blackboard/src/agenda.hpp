// SPDX-License-Identifier: Apache-2.0
// The due times of all peers.
#pragma once

#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// Orders peers by their due times, so that the cost of a step depends on the due peers only.
class Agenda {
 public:
  template <class Key>
  using Order = std::set<std::pair<Key, NodeNumber>>;
  /// Position of a peer in an order; nothing if it is not in it.
  template <class Key>
  using Place = std::optional<typename Order<Key>::iterator>;

  /// The peer is due from `due` (steady) on, or after `expires` (mission time), whichever is first.
  /// Replaces the previous call for the peer.
  void set(NodeNumber peer, std::optional<Duration> due, std::optional<MissionTime> expires);
  /// The due peers in the order of their numbers. Cost: proportional to the result.
  std::vector<NodeNumber> due(Now now) const;
  std::optional<Duration> next_due() const;
  std::optional<MissionTime> next_expiry() const;

 private:
  struct Entry {
    Place<Duration> due;
    Place<MissionTime> expires;
  };
  std::unordered_map<NodeNumber, Entry> entries_;
  Order<Duration> by_due_;
  Order<MissionTime> by_expiry_;
};

}  // namespace skein::blackboard
