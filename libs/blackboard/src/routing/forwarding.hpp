// SPDX-License-Identifier: Apache-2.0
// Where samples go next, past relays or not: those of this node, and those that it passes on.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "passed_on.hpp"
#include "router.hpp"
#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard::routing {

/// What is to be written on the channel to that node.
struct Handed {
  NodeNumber hop;
  wire::Sample sample;
};

/// How the way to a peer is used from now on.
struct TakenWay {
  std::size_t relays = 0;            ///< 0: directly
  bool is_other = false;             ///< what is under way on the one before may be lost
  std::optional<RouteChanged> news;  ///< if others are to be told
};

/// What a node does where there are relays in its team. It writes nothing: it says what is to be
/// written where, and its owner does, in that order. A sample is handed to nobody whom it has
/// passed, so it crosses no channel twice and cannot circle, whatever nodes believe of their links;
/// reports of links alone go to several. Source: spec 1.3 (relaying), docs/decisions/0024. Thread
/// rule: one thread.
class Forwarding {
 public:
  /// The configuration outlives it, and names relays.
  explicit Forwarding(const Config& config);

  bool is_relayed(NodeNumber to) const { return router_.is_relayed(to); }
  /// To whom what is for a node goes next; none: there is no channel for it.
  std::optional<NodeNumber> hop_to(NodeNumber to, wire::Slot slot) const;

  /// A heartbeat that came from its sender over radio.
  void on_heartbeat(NodeNumber from, Duration steady) { router_.on_heartbeat(from, steady); }
  /// Anything else that did, and was new.
  void on_sign_of_life(NodeNumber from, Duration steady) { router_.on_sign_of_life(from, steady); }
  /// Of others, for another, that came over that channel. Nothing: it ends here.
  std::optional<Handed> pass_on(const ChannelConfig& from, wire::Sample sample);
  /// To whom else a report of another's links is to be told.
  std::vector<Handed> learn(wire::Neighbours report);

  /// Looks for better ways: each change is to be taken, and the states sent, in this order.
  std::vector<WayChange> update(Duration steady) { return router_.update(steady); }
  TakenWay take(const WayChange& change);
  /// That others said to that peer, which may have missed them on the way before.
  std::vector<Handed> states_for(const WayChange& change) const;
  /// For those heard anew: what they passed on themselves, and may have forgotten; the rest the
  /// channel has kept for them.
  std::vector<Handed> take_reminders();
  /// Of this node's links, if they are new to others; without a header.
  std::optional<wire::Neighbours> take_report() { return router_.take_report(); }
  /// To every radio peer that it has not passed and does not come from.
  std::vector<Handed> flood(const wire::Neighbours& report) const;
  /// Steady.
  std::optional<Duration> next_wakeup() const { return router_.next_wakeup(); }

 private:
  const Config& config_;
  std::map<NodeNumber, const ChannelConfig*> channels_;  ///< by whom they go to
  Router router_;
  PassedOn passed_on_;
  std::map<NodeNumber, wire::Neighbours> reports_;  ///< by author, as passed on
  std::map<NodeNumber, Way> told_;                  ///< the ways that are not direct
};

}  // namespace skein::blackboard::routing
