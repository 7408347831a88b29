// SPDX-License-Identifier: Apache-2.0
// When which peer is to be looked at.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// So that a step costs in proportion to the peers that something is due with, not to all.
class Agenda {
 public:
  /// From `due` (steady) on, or after `expires` (mission time), whichever is first; instead of what
  /// was said of the peer before.
  void set(NodeNumber peer, std::optional<Duration> due, std::optional<MissionTime> expires);
  /// In the order of their numbers. Cost: that of the answer.
  std::vector<NodeNumber> due(Now now) const;
  std::optional<Duration> next_due() const;
  std::optional<MissionTime> next_expiry() const;

 private:
  struct Entry {
    std::optional<Duration> due;
    std::optional<MissionTime> expires;
  };
  std::map<NodeNumber, Entry> entries_;
  std::set<std::pair<Duration, NodeNumber>> by_due_;
  std::set<std::pair<MissionTime, NodeNumber>> by_expiry_;
};

}  // namespace skein::blackboard
