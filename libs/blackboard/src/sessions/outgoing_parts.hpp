// SPDX-License-Identifier: Apache-2.0
// The sending half of a session of long events or states, which are sent in parts.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// Sends long events to one peer in parts, one event after the other; long states likewise (see
/// LongStates), in a session of their own. At most kPartsUnderWay parts
/// are under way beyond the bytes that the peer has acknowledged. Where the peer says that later
/// ones have come, the one that it lacks is written again, once; where it acknowledges less than
/// before (it has restarted), all from there on. After a time-out without a new acknowledgement
/// the last part is written again, which the peer answers by what it has: all of it, where an
/// acknowledgement was lost, or a gap. So a part that is lost costs itself and a round trip.
/// Source: docs/decisions/0108.
class OutgoingParts {
 public:
  static constexpr std::uint32_t kPartsUnderWay = 16;
  static constexpr std::size_t kMostHeld = 256;
  static constexpr std::size_t kMostBytes = 16U << 20U;  ///< of held events; then full() is true

  explicit OutgoingParts(std::uint64_t first = kFirstLongEvent) : next_(first) {}

  bool full() const { return held_.size() >= kMostHeld || bytes_ >= kMostBytes; }
  bool empty() const { return held_.empty(); }
  std::size_t size() const { return held_.size(); }
  /// The number of the next one that is held.
  std::uint64_t next_number() const { return next_; }
  /// The header of an event must carry next_number().
  void hold(const wire::Sample& sample, std::uint64_t receipt);
  /// The event was reported as expired in a former life.
  void give_up(std::uint64_t number);
  /// The peer has acknowledged all events before `number`, and this many bytes of event `number`;
  /// `lacks`: later ones have come. Returns the receipt numbers of the events that it has handled,
  /// in order.
  std::vector<std::uint64_t> heard(std::uint64_t number, std::uint32_t bytes, bool lacks);
  /// In a former life the peer had acknowledged all events up to this number.
  void recall_acknowledged(std::uint64_t number);
  /// The number up to which all events are acknowledged or given up.
  std::uint64_t settled() const;
  /// Whether each part of the first was written.
  bool all_written() const { return !held_.empty() && next_byte_ == held_.front().bytes.size(); }
  /// The peer is reachable again, or knows this node by another incarnation.
  void resend() { begin_at(acked_); }
  void become(std::uint64_t incarnation);
  std::vector<EventExpired> expire(MissionTime now);
  void set_contact(bool contact) { contact_ = contact; }

  /// The part that is to be written now, without header. `time_out`: since the last one.
  std::optional<wire::Part> next(Duration now, std::uint32_t most_bytes, Duration time_out) const;
  /// The part was written; its transmission ends at `until` (steady).
  void written(const wire::Part& part, Duration until);
  std::optional<MissionTime> first_expiry() const;
  /// Steady; when next() has something.
  std::optional<Duration> next_due(std::uint32_t most_bytes, Duration time_out) const;

 private:
  struct Held {
    std::uint64_t number = 0;
    wire::Slot slot{};
    wire::SampleHeader header;
    std::vector<std::uint8_t> bytes;
    std::uint64_t receipt = 0;
    bool may_have_arrived = false;  ///< all of it was written while the peer was heard
  };
  void drop(std::vector<Held>::iterator one);
  void drop_front();
  void begin_at(std::uint32_t byte);
  std::uint32_t next_offset(std::uint32_t most_bytes) const;
  bool window_is_open(std::uint32_t most_bytes) const;

  std::vector<Held> held_;  ///< mostly empty (a vector, which then takes no heap memory)
  std::size_t bytes_ = 0;   ///< of all events held
  std::uint64_t next_;
  std::uint32_t acked_ = 0, next_byte_ = 0;  ///< of the first
  std::uint32_t last_offset_ = 0;            ///< of its part that was written last
  std::optional<std::uint32_t> gap_;         ///< begins here, and is filled
  bool fill_ = false;                        ///< that is to be written
  Duration last_written_;
  bool contact_ = false;
};

}  // namespace skein::blackboard
