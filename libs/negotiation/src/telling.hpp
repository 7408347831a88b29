// SPDX-License-Identifier: Apache-2.0
// To whom a member of a session tells what it knows, and when again.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "facts.hpp"
#include "skein/foundation/time.hpp"

namespace skein::interaction {

/// What each member is known to know, who is owed a message, and when the last ones were sent.
/// Members go by their number in the terms; 0 decides. Deterministic. A value; not safe to share
/// between threads. Cost of each call: O(members).
class Telling {
 public:
  Telling(std::size_t members, std::size_t self, MissionTime opened);

  /// The member knows these facts.
  void heard(std::size_t from, FactBits theirs);
  bool lags(std::size_t member, FactBits known) const { return lacks(told_[member], known); }
  FactBits told(std::size_t member) const { return told_[member]; }
  /// The others that are not known to know all of it, in order.
  std::vector<std::size_t> who_lags(FactBits known) const;

  void owe(std::size_t member) { owed_.insert(member); }
  void owe_all();
  /// Owes it to those who lag: the decider or, if `all`, everybody.
  void owe_news(FactBits known, bool all);
  /// Those who are owed a message, which they are sent now.
  std::set<std::size_t> take_owed(MissionTime now);
  /// Those who are told again, which they are now: all others if this member `asks`, else of those
  /// who lag the decider, and everybody if this member decides or `invites` whom it never heard.
  std::set<std::size_t> repeat(FactBits known, bool asks, bool invites, MissionTime now);

  /// Nothing has to be repeated before.
  void begin(MissionTime now) { last_sent_ = now; }
  MissionTime last_sent() const { return last_sent_; }
  /// Repetitions sent since the decider was last heard.
  int unheard() const { return unheard_; }
  /// Whether this is not the decider, and that has not answered for two repetitions.
  bool decider_is_silent() const { return unheard_ >= 2 && self_ != 0; }

 private:
  std::size_t self_;
  std::vector<FactBits> told_;  ///< the facts that each member is known to know
  std::set<std::size_t> owed_;
  MissionTime last_sent_;
  int unheard_ = 0;
};

}  // namespace skein::interaction
