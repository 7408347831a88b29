// SPDX-License-Identifier: Apache-2.0
// The sending half of what is too long to be said at once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// Long events for one peer, in parts, one event after the other. At most kPartsUnderWay parts are
/// under way beyond what the peer says it has; when it says nothing new for a time-out, or has less
/// than it had (it was restarted), they are written again from there. Whatever it has forgotten, it
/// tells; so a cut, a lost part and a restart are all one to the sender.
class OutgoingParts {
 public:
  static constexpr std::uint32_t kPartsUnderWay = 16;
  static constexpr std::size_t kMostHeld = 256;
  static constexpr std::size_t kMostBytes = 16U << 20U;  ///< beyond which no other one is held

  explicit OutgoingParts(Duration retransmission) : retransmission_(retransmission) {}

  bool full() const { return held_.size() >= kMostHeld || bytes_ >= kMostBytes; }
  bool empty() const { return held_.empty(); }
  std::size_t size() const { return held_.size(); }
  /// Of the next one: kFirstLongEvent and up.
  std::uint64_t next_number() const { return next_; }
  /// Its header must carry next_number().
  void hold(const wire::Sample& event, std::uint64_t receipt);
  /// Of a life before this one: reported as expired then.
  void give_up(std::uint64_t number);
  /// What the peer says it has: all before `number`, since nothing is begun before the one in front
  /// of it is over, and so many bytes of that. Gives the receipts of what it has handled, in order,
  /// where one was asked for.
  std::vector<std::uint64_t> heard(std::uint64_t number, std::uint32_t bytes);
  /// In a life before this one the peer had all up to this one.
  void recall_acknowledged(std::uint64_t number);
  /// The last before the first that is held: all up to it are acknowledged or given up.
  std::uint64_t settled() const;
  /// The peer has come back, or knows this node by another incarnation.
  void resend() { next_byte_ = acked_; }
  void become(std::uint64_t incarnation);
  std::vector<EventExpired> expire(MissionTime now);
  void set_contact(bool contact) { contact_ = contact; }

  /// Content, but for the header, of the part that is to be written now.
  std::optional<wire::Part> next(Duration now, std::uint32_t most_bytes, Duration round_trip) const;
  /// It was written; until then.
  void written(const wire::Part& part, Duration until);
  std::optional<MissionTime> first_expiry() const;
  /// Steady; when next() has something.
  std::optional<Duration> next_due(std::uint32_t most_bytes, Duration round_trip) const;

 private:
  struct Held {
    wire::Slot slot{};
    wire::SampleHeader header;
    std::vector<std::uint8_t> bytes;
    std::uint64_t receipt = 0;
    bool may_have_arrived = false;  ///< all of it was written while the peer was heard
  };
  void drop(std::vector<Held>::iterator one);
  void drop_front();
  bool window_is_open(std::uint32_t most_bytes) const;

  Duration retransmission_;
  std::vector<Held> held_;  ///< mostly none: it takes nothing then
  std::size_t bytes_ = 0;   ///< of all that are held
  std::uint64_t next_ = kFirstLongEvent;
  std::uint32_t acked_ = 0, next_byte_ = 0;  ///< of the first
  Duration last_written_;
  bool contact_ = false;
};

}  // namespace skein::blackboard
