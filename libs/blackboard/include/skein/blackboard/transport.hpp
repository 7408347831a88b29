// SPDX-License-Identifier: Apache-2.0
// The port between the blackboard and the middleware that carries its samples.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "skein/blackboard/channel.hpp"
#include "skein/blackboard/wire.hpp"
#include "skein/foundation/result.hpp"

namespace skein::blackboard {

/// A sample that could not be decoded; `header` is all zero if the header could not be either.
struct Malformed {
  wire::Slot slot = wire::Slot::kHeartbeat;
  wire::SampleHeader header;
  wire::Violation violation;
};

/// A received sample, decoded but not checked otherwise.
struct Arrival {
  std::size_t channel = 0;  ///< index into TransportPlan::channels
  std::variant<wire::Sample, Malformed> content;
};

/// The channels that a node wants opened. A channel that neither starts nor ends at `self` is only
/// read: in this way a spy reads other nodes' channels, with a pattern as partition ("radio/*").
struct TransportPlan {
  NodeNumber self;
  std::vector<ChannelConfig> channels;
  /// Slots read on the world channel; it is written in all its slots.
  std::vector<wire::Slot> world_reads;
};

/// Number of events that a writer keeps for readers that connect later, per slot: on the world
/// channel, and on other channels, where the blackboard's sessions repeat whatever is missing.
inline constexpr std::size_t kWorldEventDepth = 4096;
inline constexpr std::size_t kEventDepth = 256;

/// Carries samples by the delivery classes of spec 1.3, but promises less than the blackboard does:
/// - state: the last value of each (writer, slot, instance) reaches every reader connected to the
///   writer, however late it connects; a value may come again;
/// - event: reaches the connected readers in order per slot; after a reconnection old events may
///   come again, and those that have left the writer's history (by number, or by age: ten seconds)
///   do not come at all;
/// - stream: best effort to the connected readers.
/// Writer and reader of a channel are connected while both sides have it up.
/// Thread rule: all calls from one thread; the arrival callback comes from any.
class Transport {
 public:
  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  /// To be called once, before everything else. All channels start connected. The failure names the
  /// entity that could not be made.
  virtual Result<void, Failure> open(const TransportPlan& plan) = 0;
  /// Adds a channel, not of the world, which is disconnected at first. Returns its index, behind
  /// all others. Only some transports can; the failure says so.
  virtual Result<std::size_t, Failure> add(const ChannelConfig& channel) {
    return failure("channel " + channel.partition + " was not there from the start");
  }
  /// Writes a sample, whose header is complete, on a channel that starts at this node; false if the
  /// middleware did not accept it.
  virtual bool write(std::size_t channel, const wire::Sample& sample) = 0;
  /// Connects or disconnects this node's side of a channel. The failure says what the middleware
  /// refused: after a failed connection the channel is disconnected, and the call may be repeated;
  /// after a failed disconnection it may still be connected.
  virtual Result<void, Failure> set_up(std::size_t channel, bool up) = 0;
  /// What has arrived since the last call, in order of arrival.
  virtual std::vector<Arrival> take() = 0;
  /// Called soon after something arrived; it must not call back into the transport and not block.
  virtual void on_arrival(std::function<void()> notify) = 0;
};

}  // namespace skein::blackboard
