// SPDX-License-Identifier: Apache-2.0
// Which way the samples of a node go.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "link_map.hpp"
#include "link_watch.hpp"

namespace skein::blackboard::routing {

/// What is new about the way to a peer. Without a way samples go to it directly, as they do where
/// there are no relays: it may hear.
struct WayChange {
  NodeNumber peer;
  std::optional<Way> way;
  bool heard_of = false;  ///< there is a way from it past a relay
};

/// Link-state routing: every node tells all others whom it hears (wire::Neighbours, which relays
/// pass on), and reckons its ways from that. Nothing but heartbeats and these reports goes in.
class Router {
 public:
  Router(NodeNumber self, const std::set<NodeNumber>& relays, Duration period)
      : self_(self), relays_(relays.contains(self)), watch_(period), map_(self, relays) {}

  /// Whether this node passes on what is for others.
  bool relays() const { return relays_; }

  /// A heartbeat that nobody has passed on.
  void on_heartbeat(NodeNumber peer, Duration steady);
  /// Anything else new that nobody has passed on.
  void on_sign_of_life(NodeNumber peer, Duration steady) { watch_.on_sign_of_life(peer, steady); }
  void on_report(const wire::Neighbours& report);
  /// What has changed since the last call.
  std::vector<WayChange> update(Duration steady);
  /// Whom it has begun to hear, or again, since the last call.
  std::vector<NodeNumber> take_new_links() { return std::exchange(new_links_, {}); }
  /// What this node has to tell all others, if that is new.
  std::optional<wire::Neighbours> take_report();
  /// Steady; when update() is due even if nothing is heard.
  std::optional<Duration> next_wakeup() const { return watch_.next_silence(); }

  /// To whom to give what is for this node.
  NodeNumber next_hop(NodeNumber to) const;
  /// Whether it makes sense to send to it now.
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
