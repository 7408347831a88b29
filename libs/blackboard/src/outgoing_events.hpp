// SPDX-License-Identifier: Apache-2.0
// The sending half of an event session with one peer.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// Keeps every event until the peer has acknowledged it or it has expired, and says what to write
/// when. At most kEventDepth events are under way at once, which is what any transport keeps; the
/// others wait for acknowledgements.
///
/// What is not acknowledged is written again after a time-out that doubles with each writing, up to
/// kMostBackOff times the first, and starts anew when the peer is heard again or acknowledges
/// anything. Only the kAgainAtOnce oldest are: acknowledgements are cumulative, so they may turn
/// out to be all that is missing.
///
/// An expired event leaves at once if it is the oldest. Behind an older one that still waits, it
/// stays as a tombstone, expired long ago, so that the peer sees no gap it would have to wait for.
class OutgoingEvents {
 public:
  static constexpr std::size_t kAgainAtOnce = 8;
  static constexpr int kMostBackOff = 8;

  OutgoingEvents(std::size_t capacity, Duration retransmission)
      : capacity_(capacity), retransmission_(retransmission) {}

  bool full() const { return held_.size() >= capacity_; }
  std::size_t size() const { return held_.size(); }
  /// Of the next event to be held.
  std::uint64_t next_sequence() const { return next_; }
  /// The oldest event held, or the next if none is.
  std::uint64_t oldest() const { return next_ - held_.size(); }

  /// The header of `event` must carry next_sequence(). `receipt`: see SendOptions.
  void hold(wire::Sample event, std::uint64_t receipt = 0);
  /// Likewise, of a life before this one: there was room for it then.
  void recall(wire::Sample event, std::uint64_t receipt = 0);
  /// Of a life before this one: reported as expired then.
  void give_up(std::uint64_t sequence);
  /// Everything up to and including this one was handled; nonsense is ignored. Gives the receipts
  /// asked for, in the order sent.
  std::vector<std::uint64_t> acknowledge(std::uint64_t sequence);
  /// The peer has come back or started anew: everything is to be written again.
  void resend();
  /// From now on this node has this incarnation for the peer, which has taken nothing from it
  /// before: everything that is held is of it, and to be written again.
  void become(std::uint64_t incarnation);
  /// Gives up what has expired by now.
  std::vector<EventExpired> expire(MissionTime now);

  /// Whether the peer is heard, from now on.
  void set_contact(bool contact) { contact_ = contact; }

  /// What is to be written now, oldest first; counts as written. `round_trip` is what the channel
  /// itself adds before an acknowledgement can be here. Valid until the next call of anything.
  std::vector<const wire::Sample*> take_due(Now now, Duration round_trip);
  /// The last instant of the event that expires first; after it expire() has something to tell.
  std::optional<MissionTime> first_expiry() const;
  /// Steady time of the next take_due() that gives something.
  std::optional<Duration> next_due(Duration round_trip) const;

  /// For a channel that takes one after the other: the one of take_due() that is to be written now.
  /// What was never written and what is to be written again take turns. Valid as above.
  const wire::Sample* first_due(Now now, Duration round_trip) const;
  /// It is being written, until this steady time.
  void written(const wire::Sample& event, Duration until);

 private:
  struct Held {
    wire::Sample sample;
    std::optional<Duration> written = {};  ///< steady
    int writings = 0;                      ///< since the peer was last heard from
    bool may_have_arrived = false;         ///< written while the peer was heard
    bool given_up = false;
    std::uint64_t receipt = 0;
  };
  void drop_given_up();
  void drop_first(std::size_t count);
  void write(Held& event, Duration at);
  bool is_due(std::size_t index, Now now, Duration round_trip) const;
  /// When the event, which was written, is to be written again; none: not before others are gone.
  std::optional<Duration> again_at(std::size_t index, Duration round_trip) const;
  std::size_t under_way() const { return std::min(held_.size(), kEventDepth); }

  std::size_t capacity_;
  Duration retransmission_;
  std::vector<Held> held_;  ///< mostly none: it takes nothing then
  std::uint64_t next_ = 1;
  bool turn_of_old_ = false;
  bool contact_ = false;
};

}  // namespace skein::blackboard
