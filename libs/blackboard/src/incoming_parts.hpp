// SPDX-License-Identifier: Apache-2.0
// The receiving half of what is too long to be said at once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "skein/blackboard/transport.hpp"

namespace skein::blackboard {

/// Puts the parts of long events of one peer together, and lets each event through once.
///
/// | from          | part                              | to                                |
/// |---------------|-----------------------------------|-----------------------------------|
/// | any           | of a greater incarnation          | nothing there, nothing handled    |
/// | any           | of an event that was handled      | same; it is owed to say so        |
/// | any           | of a later event than that coming | that one, nothing of it there     |
/// | n bytes there | that begins at n                  | more there; whole: the event goes |
/// | n bytes there | any other                         | same; it is owed to say n         |
class IncomingParts {
 public:
  /// [byte] Nobody says more at once.
  static constexpr std::uint32_t kLongest = 16U << 20U;

  /// The event when this is its last part, or what is wrong with it; not yet checked beyond its
  /// decoding.
  std::optional<std::variant<wire::Sample, Malformed>> take(const wire::Part& part);
  /// What went through counts as handled from now on.
  void commit();
  /// The event of this number was handled in a life before this one.
  void recall(std::uint64_t incarnation, std::uint64_t number);

  /// What the peer is to be told.
  bool owes() const { return owes_; }
  void told() { owes_ = false; }
  std::uint64_t ack_incarnation() const { return incarnation_; }
  std::uint64_t ack_number() const { return number_; }
  std::uint32_t ack_bytes() const;

 private:
  std::uint64_t incarnation_ = 0;  ///< of the peer
  std::uint64_t number_ = 0;       ///< that is coming, or came last
  std::uint64_t handled_ = 0;      ///< up to this one
  std::uint32_t total_ = 0;
  std::uint32_t there_ = 0;
  std::vector<std::uint8_t> bytes_;
  bool owes_ = false;
};

}  // namespace skein::blackboard
