// SPDX-License-Identifier: Apache-2.0
// Which participant of its domain a program is on this machine.
#pragma once

#include <cstdint>
#include <optional>

#include "named_lock.hpp"

namespace skein::blackboard::rtps {

/// A number that nobody else on this machine has in the domain, whatever DDS he uses; from it
/// follow the ports. Discovery by unicast needs small numbers. Free again with this object.
class ParticipantNumber {
 public:
  /// The smallest whose ports nobody has; nothing if all are taken.
  static std::optional<ParticipantNumber> claim(std::uint32_t domain);
  std::uint32_t value() const { return value_; }

 private:
  ParticipantNumber(std::uint32_t value, NamedLock lock) : value_(value), lock_(std::move(lock)) {}

  std::uint32_t value_;
  NamedLock lock_;
};

}  // namespace skein::blackboard::rtps
