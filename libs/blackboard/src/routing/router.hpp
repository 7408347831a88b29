// SPDX-License-Identifier: Apache-2.0
// The routes of a node's samples.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "link_map.hpp"
#include "link_watch.hpp"

namespace skein::blackboard::routing {

/// A change of the route to a peer. Without a route samples are sent to the peer directly, as in a
/// system without relays, since it may hear them.
struct WayChange {
  NodeNumber peer;
  std::optional<Way> way;
  bool heard_of = false;  ///< there is a route from the peer to this node over a relay
};

/// Link-state routing: every node reports to all others which nodes it hears (wire::Neighbours,
/// flooded by relays), and computes its routes from these reports and from direct heartbeats.
class Router {
 public:
  Router(NodeNumber self, const std::set<NodeNumber>& relays, Duration period)
      : self_(self), relays_(relays.contains(self)), watch_(period), map_(self, relays) {}

  /// Whether this node is a relay.
  bool relays() const { return relays_; }

  /// A heartbeat arrived directly, without relays.
  void on_heartbeat(NodeNumber peer, Duration steady);
  /// Anything else new that nobody has passed on.
  void on_sign_of_life(NodeNumber peer, Duration steady) { watch_.on_sign_of_life(peer, steady); }
  void on_report(const wire::Neighbours& report);
  /// The route changes since the last call.
  std::vector<WayChange> update(Duration steady);
  /// The nodes that are newly, or again, heard directly since the last call.
  std::vector<NodeNumber> take_new_links() { return std::exchange(new_links_, {}); }
  /// The report of this node's links for all others; nothing if it has not changed.
  std::optional<wire::Neighbours> take_report();
  /// Steady time at which update() is due even if nothing is heard.
  std::optional<Duration> next_wakeup() const { return watch_.next_silence(); }

  /// The first hop on the route to `to`; `to` itself if there is no route.
  NodeNumber next_hop(NodeNumber to) const;
  /// Whether there is a route to `to`, or `to` is heard directly.
  bool reaches(NodeNumber to) const { return ways_.contains(to) || watch_.hears(to); }
  bool is_relayed(NodeNumber to) const { return next_hop(to) != to; }

 private:
  void tell_links();

  NodeNumber self_;
  bool relays_;
  LinkWatch watch_;
  LinkMap map_;
  std::map<NodeNumber, Way> ways_;
  std::set<NodeNumber> heard_of_;
  std::vector<NodeNumber> new_links_;
  bool is_stale_ = true;
  bool has_news_ = true;  ///< others do not know yet whom this node hears
};

}  // namespace skein::blackboard::routing
