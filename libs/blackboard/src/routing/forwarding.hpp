// SPDX-License-Identifier: Apache-2.0
// Forwarding: the next hop of this node's own samples and of those that it relays.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "passed_on.hpp"
#include "router.hpp"
#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard::routing {

/// A sample to be written on the channel to the node `hop`.
struct Handed {
  NodeNumber hop;
  wire::Sample sample;
};

/// The route to a peer from now on.
struct TakenWay {
  std::size_t relays = 0;            ///< number of relays; 0: direct
  bool is_other = false;             ///< differs from the former one, where samples may be lost
  std::optional<RouteChanged> news;  ///< present if the change is to be reported
};

/// The relaying of one node, present if its system has relays. Writes nothing itself: its owner
/// writes the returned samples, in their order. A sample is never handed to a node that it has
/// visited, so it crosses no channel twice and cannot circle, whatever nodes believe of their
/// links. Only link reports (wire::Neighbours) are handed to several nodes. Source: spec 1.3
/// (relaying), docs/decisions/0024. Thread rule: one thread.
class Forwarding {
 public:
  /// The configuration must outlive this object. Precondition: it names relays.
  explicit Forwarding(const Config& config);

  bool is_relayed(NodeNumber to) const { return router_.is_relayed(to); }
  /// The next hop for a sample of this slot to `to`; none: there is no channel for it.
  std::optional<NodeNumber> hop_to(NodeNumber to, wire::Slot slot) const;

  /// A heartbeat arrived directly from its sender over radio.
  void on_heartbeat(NodeNumber from, Duration steady) { router_.on_heartbeat(from, steady); }
  /// Anything else that did, and was new.
  void on_sign_of_life(NodeNumber from, Duration steady) { router_.on_sign_of_life(from, steady); }
  /// Of others, for another, that came over that channel. Nothing: it ends here.
  std::optional<Handed> pass_on(const ChannelConfig& from, wire::Sample sample);
  void forget(NodeNumber origin) { passed_on_.forget(origin.value()); }
  /// Learns another node's link report, and returns it for the nodes that it is to be flooded to.
  std::vector<Handed> learn(wire::Neighbours report);

  /// Recomputes the routes. For each change take() is to be called, and then states_for() to be
  /// written, in this order.
  std::vector<WayChange> update(Duration steady) { return router_.update(steady); }
  TakenWay take(const WayChange& change);
  /// The relayed states for that peer, which it may have missed on the former route.
  std::vector<Handed> states_for(const WayChange& change) const;
  /// For nodes that are newly heard: the link reports that they had passed on and may have
  /// forgotten. The channel's transport keeps everything else for them.
  std::vector<Handed> take_reminders();
  /// The report of this node's links, without header; nothing if it has not changed.
  std::optional<wire::Neighbours> take_report() { return router_.take_report(); }
  /// The report for every radio peer that it has not visited and does not come from.
  std::vector<Handed> flood(const wire::Neighbours& report) const;
  /// Steady.
  std::optional<Duration> next_wakeup() const { return router_.next_wakeup(); }

 private:
  const Config& config_;
  std::map<NodeNumber, const ChannelConfig*> channels_;  ///< by receiver
  Router router_;
  PassedOn passed_on_;
  std::map<NodeNumber, wire::Neighbours> reports_;  ///< by author, as passed on
  std::map<NodeNumber, Way> told_;                  ///< the ways that are not direct
};

}  // namespace skein::blackboard::routing
