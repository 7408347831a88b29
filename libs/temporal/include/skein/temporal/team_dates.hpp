// SPDX-License-Identifier: Apache-2.0
// When the others come: the frontiers of a team put together, as one of its agents knows them.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "skein/foundation/time.hpp"
#include "skein/temporal/frontier.hpp"

namespace skein::temporal {

/// When a meeting can end because of the others, and when one has to be there because of them.
struct PartnerDates {
  /// When the last of the other senders comes, with all durations least and all greatest; max():
  /// never (each waits for the other), or no figure bounds it.
  MissionTime soonest, slowest;
  bool all_there = false;  ///< they have come; soonest and slowest are when
  std::string last;        ///< who comes last, as foreseen
  /// Later no other could keep to its plan; absent: nobody says so, or this one does not plan to
  /// come yet (late is better than never).
  std::optional<MissionTime> needed;
  std::string needed_by;
  /// Each waits for the other, and it is this one that gives way: it goes to the meeting only after
  /// this other one of its own.
  std::optional<MeetingId> behind;
  bool operator==(const PartnerDates&) const = default;
};

/// One agent's part of the consistency of plans between agents, sans-IO. Each tells its frontier
/// when it changes, as a state: the last word of each counts, in whatever order and after whatever
/// cut it comes. Who is out of reach is supposed to keep to what it said last.
///
/// Where some wait for each other in a circle, one of them gives way, the same whoever works it out
/// from the same words: of those who wait in a meeting of theirs while another one, of a smaller
/// number, is waited for, one that has not come to the former yet if there is such, and the last by
/// name.
///
/// Laws. Once all have heard each other's last words, the dates are those of the network of the
/// whole team: earliest arrivals in the courses of least and of greatest durations, latest ones in
/// that of the greatest, without what the agent's own plan bounds from above. Nothing follows from
/// itself: what an agent says does not contain what it heard, or says what of it. Where all tell
/// `bounds_for` each other until nothing changes, the earliest dates are the same; of the latest
/// none is earlier than it should. Thread rule: not safe to share.
/// Source: M 4.3 (DIP-M); spec 5.3.
class TeamDates {
 public:
  explicit TeamDates(std::string self) : self_(std::move(self)) {}

  /// Precondition: no fault.
  void say(Frontier own) { known_[self_] = std::move(own); }
  void hear(const std::string& from, Frontier frontier) { known_[from] = std::move(frontier); }
  /// It has no plan any more, or another node has it.
  void forget(const std::string& peer) { known_.erase(peer); }
  /// What it did since then nobody has heard: what its last word says of the present, it says of
  /// that instant. Nothing: it is heard.
  void out_of_reach(const std::string& peer, std::optional<MissionTime> since) {
    unheard_since_.erase(peer);
    if (since) unheard_since_[peer] = *since;
  }
  const std::map<std::string, Frontier>& known() const { return known_; }

  /// What another one is told where agents tell dates (DIP-L) in place of what lies between them
  /// (DIP-M): of the meetings that are its as well, when this agent comes and by when it has to,
  /// with what all others told, and what that rests on. So nobody finds his own date in another's
  /// after it has changed, and circles of waits are seen. Of what never comes the way on to other
  /// meetings is told too. To be told when it changes. What others bound counts, what the receiver
  /// bounds itself does not. By whose leaving somebody has his air is in the greatest dates; of
  /// several limits of a node the tightest is told, so where that comes back to one that it has
  /// passed no limit is. Cost: as `dates`, for each receiver.
  Frontier bounds_for(const std::string& receiver) const;

  /// Of each meeting of its own, or in which others count on it, of which every other sender is
  /// known to be on its way. Cost: O(nodes · arcs) at worst of what is known; where nobody waits
  /// for himself, a few rounds.
  std::map<MeetingId, PartnerDates> dates(MissionTime now) const;

 private:
  std::string self_;
  std::map<std::string, Frontier> known_;
  std::map<std::string, MissionTime> unheard_since_;
};

}  // namespace skein::temporal
