// SPDX-License-Identifier: Apache-2.0
// Expected arrivals of the partners at meetings, from the frontiers of a team as known to one
// agent.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "skein/foundation/time.hpp"
#include "skein/temporal/frontier.hpp"

namespace skein::temporal {

/// Dates of a meeting that result from the other agents: their arrival, and the date by which they
/// need this agent.
struct PartnerDates {
  /// Arrival of the last of the other senders, with least and with greatest durations; max(): never
  /// (a circle of waits), or unbounded.
  MissionTime soonest, slowest;
  bool all_there = false;  ///< all have arrived; soonest and slowest are the actual date
  std::string last;        ///< the sender expected to arrive last
  /// Latest arrival of this agent with which the others can keep their plans; absent: unbounded, or
  /// this agent does not plan to come yet (late is better than never).
  std::optional<MissionTime> needed;
  std::string needed_by;
  /// Present in a circle of waits in which this agent gives way: it should go to the meeting only
  /// after this other meeting of its own.
  std::optional<MeetingId> behind;
  bool operator==(const PartnerDates&) const = default;
};

/// One agent's part of the temporal consistency of plans between agents, sans-IO. Each agent sends
/// its frontier when it changes, as a state: the last one of each agent counts, whatever the order
/// and cuts. An agent out of reach is assumed to keep to its last frontier.
///
/// In a circle of waits one agent gives way, the same for all who compute it from the same
/// frontiers: of the agents that wait in a meeting while another of their meetings, of a smaller
/// number, is waited for, one that has not arrived at the former yet, if there is one; of several
/// the last by name.
///
/// Laws. Once all have received each other's last frontiers, the dates are those of the network of
/// the whole team: earliest arrivals with least and with greatest durations, latest ones with
/// greatest durations, without the upper bounds of the agent's own plan. There is no feedback: what
/// an agent sends does not contain what it received, or names its sources. If instead all exchange
/// `bounds_for` until nothing changes, the earliest dates are the same, and no latest date is too
/// early. Thread rule: not safe to share.
/// Source: M 4.3 (DIP-M); spec 5.3.
class TeamDates {
 public:
  explicit TeamDates(std::string self) : self_(std::move(self)) {}

  /// Precondition: no fault.
  void say(Frontier own) { known_[self_] = std::move(own); }
  void hear(const std::string& from, Frontier frontier) { known_[from] = std::move(frontier); }
  /// The peer has no plan any more, or another node has taken it over.
  void forget(const std::string& peer) { known_.erase(peer); }
  /// The peer is out of reach since `since`: constraints of its last frontier on the present refer
  /// to that instant. Nothing: it is in reach.
  void out_of_reach(const std::string& peer, std::optional<MissionTime> since) {
    unheard_since_.erase(peer);
    if (since) unheard_since_[peer] = *since;
  }
  const std::map<std::string, Frontier>& known() const { return known_; }

  /// The frontier for `receiver` if agents exchange dates (DIP-L) instead of macro-constraints
  /// (DIP-M): for each common meeting the arrival of this agent and its latest permitted date,
  /// given all other frontiers, together with the dates that they rest on. So no agent takes its
  /// own outdated date back from another, and circles of waits are detected. For arrivals that
  /// never come the arcs on to other meetings are included too. To be sent when it changes. Upper
  /// bounds of others count, those of the receiver do not. Waits for air count in the greatest
  /// dates only; of several limits of a node only the tightest is included, and none if it has
  /// already passed the receiver. Cost: as `dates`, for each receiver.
  Frontier bounds_for(const std::string& receiver) const;

  /// Dates of the meetings of this agent, or for which others expect it, in which the arrival of
  /// every other sender is known. Cost: O(nodes · arcs) of the known frontiers at worst; a few
  /// rounds without circles of waits.
  std::map<MeetingId, PartnerDates> dates(MissionTime now) const;

 private:
  std::string self_;
  std::map<std::string, Frontier> known_;
  std::map<std::string, MissionTime> unheard_since_;
};

}  // namespace skein::temporal
