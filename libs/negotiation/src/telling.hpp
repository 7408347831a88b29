// SPDX-License-Identifier: Apache-2.0
// To whom a member of a session tells what it knows, and when again.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "facts.hpp"
#include "skein/foundation/repeats.hpp"
#include "skein/foundation/time.hpp"

namespace skein::interaction {

/// What each member is known to know and was told last, who is owed a message, and when something
/// is told again. Over a narrow channel an answer takes longer than a pause over a wide one: what
/// is on its way is not told again on demand, and the pauses begin with the time that answers took
/// last. Members go by their number in the terms; 0 decides. Deterministic. A value; not safe to
/// share between threads. Cost of each call: O(members).
class Telling {
 public:
  /// `first`, `most`: the shortest and the longest pause until something is told again; as long as
  /// there is no news, the pauses double.
  Telling(std::size_t members, std::size_t self, MissionTime opened, Duration first, Duration most);

  /// As it did before.
  void expect_answers_in(std::size_t member, Duration time) { members_[member].round_trip = time; }
  /// How long the last answer of the member took; 0: not known.
  Duration answered_in(std::size_t member) const { return members_[member].round_trip; }

  /// The member knows these facts, as it says.
  void heard(std::size_t from, FactBits theirs, MissionTime now);
  /// The member is told these facts now.
  void tells(std::size_t member, FactBits known, MissionTime now);
  bool lags(std::size_t member, FactBits known) const {
    return lacks(members_[member].knows, known);
  }
  /// The others that are not known to know all of it, in order.
  std::vector<std::size_t> who_lags(FactBits known) const;

  void owe(std::size_t member) { owed_.insert(member); }
  void owe_all();
  /// Owes it to those who lag: the decider or, if `all`, everybody.
  void owe_news(FactBits known, bool all);
  /// Those who are owed a message and to whom the same is not on its way, which they are sent now.
  std::set<std::size_t> take_owed(FactBits known, MissionTime now);
  /// Those who are told again, which they are now: all others if this member `asks`, else of those
  /// who lag the decider, and everybody if this member decides or `invites` whom it never heard.
  /// `within`: the pause after it is no longer, unless answers take longer.
  std::set<std::size_t> repeat(FactBits known, bool asks, bool invites, MissionTime now,
                               Duration within);

  /// Nothing has to be repeated before.
  void begin(MissionTime now) { again_.last = now; }
  MissionTime last_sent() const { return again_.last; }
  /// When what nobody answered is told again.
  MissionTime due() const { return asks_every_ ? again_.last + *asks_every_ : again_.due(); }
  /// From now on the pauses are as long as this.
  void ask_every(Duration pause) { asks_every_ = pause; }
  /// Repetitions sent since the decider was last heard.
  int unheard() const { return unheard_; }
  /// Whether this is not the decider, and that has not answered for two repetitions.
  bool decider_is_silent() const { return unheard_ >= 2 && self_ != 0; }
  std::string state_text() const;

 private:
  struct Member {
    FactBits knows = 0;       ///< is known to know
    FactBits told = 0;        ///< as it was told last
    bool was_told = false;    ///< anything
    bool has_to_say = false;  ///< that it knows what it was told
    MissionTime since;        ///< when it was told that first
    MissionTime last;         ///< and last
    Duration round_trip;      ///< from then until it said so, the last time
  };
  bool is_on_its_way(std::size_t to, FactBits known, MissionTime now) const;
  /// Until these have answered, as far as one knows.
  Duration pause(const std::set<std::size_t>& to) const;

  std::size_t self_;
  std::vector<Member> members_;
  std::set<std::size_t> owed_;
  Duration first_, most_;
  Repeats again_;
  std::optional<Duration> asks_every_;
  int unheard_ = 0;
};

}  // namespace skein::interaction
