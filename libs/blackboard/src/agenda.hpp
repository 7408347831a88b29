// SPDX-License-Identifier: Apache-2.0
// When which peer is to be looked at.
#pragma once

#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// So that a step costs in proportion to the peers that something is due with, not to all.
class Agenda {
 public:
  template <class Key>
  using Order = std::set<std::pair<Key, NodeNumber>>;
  /// In an order, if it is in it.
  template <class Key>
  using Place = std::optional<typename Order<Key>::iterator>;

  /// From `due` (steady) on, or after `expires` (mission time), whichever is first; instead of what
  /// was said of the peer before.
  void set(NodeNumber peer, std::optional<Duration> due, std::optional<MissionTime> expires);
  /// In the order of their numbers. Cost: that of the answer.
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
