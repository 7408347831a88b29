// SPDX-License-Identifier: Apache-2.0
// The port between the blackboard and what carries its samples.
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "skein/blackboard/channel.hpp"
#include "skein/blackboard/wire.hpp"
#include "skein/foundation/result.hpp"

namespace skein::blackboard {

/// A sample that could not be decoded; `header` is all zero if not even that could be.
struct Malformed {
  wire::Slot slot = wire::Slot::kHeartbeat;
  wire::SampleHeader header;
  wire::Violation violation;
};

/// One thing that came in, not yet checked beyond its decoding.
struct Arrival {
  std::size_t channel = 0;  ///< index into TransportPlan::channels
  std::variant<wire::Sample, Malformed> content;
};

/// What a node wants opened. A channel that neither starts nor ends at `self` is only listened to:
/// so a spy reads what others say, with a pattern as partition ("radio/*").
struct TransportPlan {
  NodeNumber self;
  std::vector<ChannelConfig> channels;
  /// Slots read on the world channel; it is written in all its slots.
  std::vector<wire::Slot> world_reads;
};

/// Events a writer keeps for readers that connect later, per slot: on the world channel, and on the
/// others, where sessions make good whatever is missing.
inline constexpr std::size_t kWorldEventDepth = 4096;
inline constexpr std::size_t kEventDepth = 256;

/// Carries samples by the delivery classes of spec 1.3, but promises less than the blackboard does:
/// - state: the last value of each (writer, slot, instance) reaches every reader connected to the
///   writer, however late it connects; a value may come again;
/// - event: reaches the connected readers in order per slot; after a reconnection old ones may come
///   again, and what left the history of the writer (by number, or by age: ten seconds) does not
///   come at all;
/// - stream: reaches a connected reader or not.
/// Writer and reader of a channel are connected while both sides have it up.
/// Thread rule: all calls from one thread; the arrival callback comes from any.
class Transport {
 public:
  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  /// Once, before everything else; all channels start up. The failure says what could not be made.
  virtual Result<void, Failure> open(const TransportPlan& plan) = 0;
  /// Hands a sample, whose header is complete, to a channel that starts at this node; false if it
  /// was not taken.
  virtual bool write(std::size_t channel, const wire::Sample& sample) = 0;
  /// Connects or disconnects this node's side of a channel. The failure says what the middleware
  /// refuses: asked to connect, the channel then stays disconnected, and may be asked again; asked
  /// to disconnect, it may still be connected.
  virtual Result<void, Failure> set_up(std::size_t channel, bool up) = 0;
  /// What has arrived since the last call, in order of arrival.
  virtual std::vector<Arrival> take() = 0;
  /// Called soon after something arrived; it must not call back into the transport and not block.
  virtual void on_arrival(std::function<void()> notify) = 0;
};

}  // namespace skein::blackboard
