// SPDX-License-Identifier: Apache-2.0
// The direct links into a node.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard::routing {

/// Links into this node, from the heartbeats that come over them. A link is there with the first
/// heartbeat and gone after three periods in which nothing came. One that has come back is not
/// steady before kSteadyAfter heartbeats: routes prefer others meanwhile, so that a flapping link
/// does not pull traffic to and fro. Source: spec 1.3 (reachability).
class LinkWatch {
 public:
  static constexpr int kSteadyAfter = 5;

  explicit LinkWatch(Duration period) : silence_(period + period + period) {}

  /// True if heard() changes.
  bool on_heartbeat(NodeNumber peer, Duration steady);
  /// Anything else that came over the link, as long as it is there.
  void on_sign_of_life(NodeNumber peer, Duration steady);
  /// Finds who has fallen silent; whether there is any.
  bool update(Duration steady);
  /// Steady time at which update() detects a silent peer if no heartbeat comes before.
  std::optional<Duration> next_silence() const;

  bool hears(NodeNumber peer) const;
  /// The peers whose links are up, by number.
  std::vector<wire::Neighbour> heard() const;

 private:
  struct Link {
    Duration last;
    bool up = false;
    bool was_lost = false;
    int in_a_row = 0;  ///< heartbeats since it came back
    bool steady() const { return !was_lost || in_a_row >= kSteadyAfter; }
  };
  Duration silence_;
  std::map<NodeNumber, Link> links_;
};

}  // namespace skein::blackboard::routing
