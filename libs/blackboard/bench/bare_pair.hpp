// SPDX-License-Identifier: Apache-2.0
// Request and reply over a bare DDS, with the types that its compiler generates.
#pragma once

#include <cstdint>
#include <memory>

#include "skein/blackboard/network.hpp"

namespace skein::blackboard::bench {

/// One writer and one reader, of the QoS of an event slot, and nothing else: no sessions, no
/// checks, no header. What comes is taken by a listener and handed to the waiting thread, as a
/// program does that works outside the threads of its middleware.
class BareSide {
 public:
  enum class Role : std::uint8_t { kAsks, kAnswers };
  BareSide() = default;
  BareSide(const BareSide&) = delete;
  BareSide& operator=(const BareSide&) = delete;
  virtual ~BareSide() = default;

  /// Asks and waits for the answer; false if none comes within 5 s.
  virtual bool ask(std::uint64_t command) = 0;
  /// Answers for ever.
  virtual void serve() = 0;
};

std::unique_ptr<BareSide> make_bare_fastdds_side(std::uint32_t domain, BareSide::Role role);
std::unique_ptr<BareSide> make_bare_cyclonedds_side(std::uint32_t domain, BareSide::Role role);
inline std::unique_ptr<BareSide> make_bare_side(DdsVendor vendor, std::uint32_t domain,
                                                BareSide::Role role) {
  return vendor == DdsVendor::kFastDds ? make_bare_fastdds_side(domain, role)
                                       : make_bare_cyclonedds_side(domain, role);
}

/// Participant numbers clear of those that the blackboards of the two processes take.
constexpr std::uint32_t bare_number(BareSide::Role role) {
  return role == BareSide::Role::kAsks ? 20 : 21;
}

/// One writer or one reader of telemetry, of the QoS of a stream slot, and nothing else. What comes
/// is taken by a listener and counted.
class BareStream {
 public:
  enum class Role : std::uint8_t { kWrites, kReads };
  BareStream() = default;
  BareStream(const BareStream&) = delete;
  BareStream& operator=(const BareStream&) = delete;
  virtual ~BareStream() = default;

  virtual bool write(std::uint64_t sequence) = 0;
  virtual std::uint64_t taken() const = 0;
};

std::unique_ptr<BareStream> make_bare_fastdds_stream(std::uint32_t domain, BareStream::Role role);
std::unique_ptr<BareStream> make_bare_cyclonedds_stream(std::uint32_t domain,
                                                        BareStream::Role role);
inline std::unique_ptr<BareStream> make_bare_stream(DdsVendor vendor, std::uint32_t domain,
                                                    BareStream::Role role) {
  return vendor == DdsVendor::kFastDds ? make_bare_fastdds_stream(domain, role)
                                       : make_bare_cyclonedds_stream(domain, role);
}

}  // namespace skein::blackboard::bench
