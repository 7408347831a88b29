// SPDX-License-Identifier: Apache-2.0
// Times until an answer may be there.
#pragma once

#include <cstddef>
#include <cstdint>

#include "skein/blackboard/channel.hpp"
#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// How long it may take until what was written on the channel to a peer is acknowledged on the one
/// back. A value. Source: docs/decisions/0043-datagrams-of-one-packet.md, 0108.
struct RoundTrip {
  /// Long enough to acknowledge a burst at once, short against any retransmission time.
  static constexpr Duration kAtOnce = Duration::milliseconds(10);

  Duration latency;  ///< of both channels
  double out = 0;    ///< capacity of the channel to the peer [bit/s]; 0: unlimited
  double back = 0;   ///< of the one from it
  std::size_t relays = 0;
  Duration period;  ///< of heartbeats

  /// Of events: the acknowledgement waits for others like it and for a long sample. Of states in
  /// parts: for that alone.
  Duration of_event() const {
    return behind(kLongSample + (kHeartbeatsBetween + 1) * heartbeat_bytes());
  }
  Duration of_state_part() const {
    return behind(kLongSample) + Duration::nanoseconds(period.count() / 10);
  }
  /// On a limited channel, acknowledgements leave room for so many others between them.
  Duration acknowledgement_delay() const {
    return out <= 0 ? kAtOnce : kAtOnce + airtime(kHeartbeatsBetween * heartbeat_bytes(), out);
  }

 private:
  static constexpr std::size_t kHeartbeatsBetween = 4;
  /// As long as most of what goes over radio [byte].
  static constexpr std::size_t kLongSample = 512;

  // Bytes for bytes: a long sample of ours may be under way before this one. Nothing is known of
  // what others take between relays: a period each is more than most do.
  Duration behind(std::size_t bytes_back) const {
    Duration all = latency;
    all = all + Duration::nanoseconds(period.count() * static_cast<std::int64_t>(relays));
    if (out > 0) all = all + airtime(kLongSample, out);
    return back > 0 ? all + airtime(bytes_back, back) : all;
  }
};

}  // namespace skein::blackboard
