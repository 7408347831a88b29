// SPDX-License-Identifier: Apache-2.0
// The sending half of an event session with one peer.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// Keeps every event until the peer has acknowledged it or it has expired, and decides what is
/// written when. At most kEventDepth events are under way at once, which every transport keeps; the
/// others wait for acknowledgements.
///
/// An unacknowledged event is written again after a time-out that doubles with each repetition, up
/// to kMostBackOff times the first, and is reset when the peer is heard again or acknowledges
/// anything. Only the kAgainAtOnce oldest events are repeated: acknowledgements are cumulative, so
/// these may be all that is missing.
///
/// An expired event leaves at once if it is the oldest. Behind an older one that still waits, it
/// stays as a tombstone, empty and expired long ago, so that the peer sees no gap it would have to
/// wait for. Of such events in a row only the last is left, for up to kMostInARow of them: a cut on
/// a narrow channel leaves dozens, and what still counts waits behind them; one of an hour leaves
/// thousands, which must not fill what is held.
class OutgoingEvents {
 public:
  static constexpr std::size_t kAgainAtOnce = 8;
  static constexpr int kMostBackOff = 8;
  /// Less than are under way, so that a peer has room for all whose places a tombstone keeps.
  static constexpr std::uint64_t kMostInARow = kEventDepth / 2;

  OutgoingEvents(std::size_t capacity, Duration retransmission)
      : capacity_(capacity), retransmission_(retransmission) {}

  bool full() const { return held_.size() >= capacity_; }
  std::size_t size() const { return held_.size(); }
  /// The sequence number of the next event to be held.
  std::uint64_t next_sequence() const { return next_; }
  /// The oldest event held, or the next if none is.
  std::uint64_t oldest() const { return held_.empty() ? next_ : held_.front().first(); }

  /// The header of `event` must carry next_sequence(). `receipt`: see SendOptions.
  void hold(wire::Sample event, std::uint64_t receipt = 0);
  /// The same for an event of a former life, whatever the capacity.
  void recall(wire::Sample event, std::uint64_t receipt = 0);
  /// The event was reported as expired in a former life.
  void give_up(std::uint64_t sequence);
  /// Everything up to and including `sequence` was handled by the peer; impossible numbers are
  /// ignored. Returns the receipt numbers of the acknowledged events, in the order sent.
  std::vector<std::uint64_t> acknowledge(std::uint64_t sequence);
  /// The peer is reachable again or has restarted: all events are to be written again.
  void resend();
  /// Towards the peer this node has this incarnation from now on, of which the peer has received
  /// nothing: all events held get it, and are to be written again.
  void become(std::uint64_t incarnation);
  /// Gives up the expired events and returns them.
  std::vector<EventExpired> expire(MissionTime now);

  /// Sets whether the peer is heard.
  void set_contact(bool contact) { contact_ = contact; }

  /// The events to be written now, oldest first; they count as written. `round_trip`: time that the
  /// channel itself adds until an acknowledgement can arrive. Valid until the next call.
  std::vector<const wire::Sample*> take_due(Now now, Duration round_trip);
  /// The earliest expiry of the events held; after it expire() returns something.
  std::optional<MissionTime> first_expiry() const;
  /// Steady time of the next take_due() that gives something.
  std::optional<Duration> next_due(Duration round_trip) const;

  /// For a channel of limited capacity: the event to be written next. New events and repetitions
  /// take turns. Valid until the next call.
  const wire::Sample* first_due(Now now, Duration round_trip) const;
  /// The transmission of the event ends at this steady time.
  void written(const wire::Sample& event, Duration until);

 private:
  struct Held {
    wire::Sample sample;
    std::optional<Duration> written = {};  ///< steady
    int writings = 0;                      ///< since the peer was last heard from
    bool may_have_arrived = false;         ///< written while the peer was heard
    bool given_up = false;
    std::uint64_t receipt = 0;
    std::uint64_t places = 1;  ///< its own and those right before it, of tombstones

    std::uint64_t number() const { return wire::header_of(sample).sequence_number; }
    std::uint64_t first() const { return number() - places + 1; }
  };
  std::vector<Held>::iterator find(std::uint64_t sequence);
  void give_up(Held& event);
  /// The tombstones at the front are gone; of others in a row the last one stands for all.
  void settle_tombstones();
  void drop_first(std::size_t count);
  void write(Held& event, Duration at);
  bool is_due(std::size_t index, Now now, Duration round_trip) const;
  /// When the event, which was written, is to be repeated; none: not before older ones are gone.
  std::optional<Duration> again_at(std::size_t index, Duration round_trip) const;
  /// Number of those that may be written now.
  std::size_t under_way() const;

  std::size_t capacity_;
  Duration retransmission_;
  std::vector<Held> held_;  ///< mostly empty (a vector, which then takes no heap memory)
  std::uint64_t next_ = 1;
  bool turn_of_old_ = false;
  bool contact_ = false;
};

}  // namespace skein::blackboard
