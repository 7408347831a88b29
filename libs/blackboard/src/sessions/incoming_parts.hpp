// SPDX-License-Identifier: Apache-2.0
// The receiving half of a session of long events or states, which are sent in parts.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "skein/blackboard/transport.hpp"

namespace skein::blackboard {

/// Reassembles the long events of one peer, or its long states, and delivers each once.
///
/// | from          | part                              | to                                |
/// |---------------|-----------------------------------|-----------------------------------|
/// | any           | of a greater incarnation          | nothing there, nothing handled    |
/// | any           | of an event that was handled      | same; acknowledgement owed        |
/// | any           | of a later event than that coming | that one, nothing of it there     |
/// | n bytes there | that begins at n                  | more there; if complete: delivery |
/// | n bytes there | that begins before n              | same; acknowledgement of n owed   |
/// | n bytes there | that begins after n               | that one kept; the same owed, as  |
/// |               |                                   | lacking what follows n            |
class IncomingParts {
 public:
  /// Parts that are kept beyond a gap: as many as are under way.
  static constexpr std::size_t kMostLater = 16;
  /// [byte] Greatest length of an event.
  static constexpr std::uint32_t kLongest = 16U << 20U;

  /// `of`: events or states. `quiet`: so many parts that come as they should, or behind a gap that
  /// was named, need no acknowledgement.
  explicit IncomingParts(wire::SlotClass of = wire::SlotClass::kEvent, std::uint32_t quiet = 0)
      : of_(of), quiet_(quiet) {}

  /// Returns the event if this is its last part (decoded, not checked otherwise), or why it cannot
  /// be decoded.
  std::optional<std::variant<wire::Sample, Malformed>> take(const wire::Part& part);
  /// All delivered events count as handled from now on.
  void commit();
  /// The event with this number was handled in a former life.
  void recall(std::uint64_t incarnation, std::uint64_t number);

  /// Whether an acknowledgement is owed to the peer.
  bool owes() const { return owes_; }
  void told();
  std::uint64_t ack_incarnation() const { return incarnation_; }
  std::uint64_t ack_number() const { return number_; }
  std::uint32_t ack_bytes() const;
  /// A later part than that which follows these bytes has come.
  bool ack_lacks() const { return !later_.empty(); }

 private:
  bool makes_sense(const wire::Part& part) const;
  void begin(const wire::Part& part);
  void add(std::uint32_t offset, const std::vector<std::uint8_t>& content);
  void add_later();

  wire::SlotClass of_;
  std::uint32_t quiet_;
  std::uint32_t since_told_ = 0;   ///< parts that came as they should
  std::uint64_t incarnation_ = 0;  ///< of the peer
  std::uint64_t number_ = 0;       ///< of the event that is coming, or came last
  std::uint64_t handled_ = 0;      ///< number of the last event handled
  std::uint32_t total_ = 0;
  std::uint32_t there_ = 0;
  std::vector<std::uint8_t> bytes_;
  bool owes_ = false;
  std::map<std::uint32_t, std::vector<std::uint8_t>> later_;  ///< by offset, beyond a gap
  std::optional<std::uint32_t> gap_told_;                     ///< where the gap begins
};

}  // namespace skein::blackboard
