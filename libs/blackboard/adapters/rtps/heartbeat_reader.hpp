// SPDX-License-Identifier: Apache-2.0
// One common reader for the heartbeats of all peers over radio.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "adapters/rtps/link.hpp"
#include "skein/blackboard/dds_config.hpp"
#include "skein/blackboard/transport.hpp"

namespace skein::blackboard::rtps {

/// Heartbeats are read from the beginning on every channel, and each endpoint is told to every
/// participant: one reader in the partitions of all radio channels that end at a node takes the
/// place of one for each peer. It stays through cuts; a heartbeat of a channel that is cut at this
/// end is dropped by the owner, which for a stream is the same as not being connected. Immutable
/// once it is planned; any thread.
class HeartbeatReader {
 public:
  /// None where permissions are judged by partition (keys), where one wants all endpoints of each
  /// channel (spies).
  static std::optional<HeartbeatReader> of(const TransportPlan& plan, const DdsConfig& config);

  /// The plan of this reader, as a channel of its own.
  const LinkPlan& link() const { return link_; }
  bool covers(std::size_t channel) const;
  /// The channel that it came over: from whoever passed it on last, or else from its origin. Who is
  /// none of the peers is named on the first channel, as a stranger there.
  std::size_t channel_of(const Arrival& arrival) const;

 private:
  LinkPlan link_;
  std::map<NodeNumber, std::size_t> channels_;  ///< by peer
};

}  // namespace skein::blackboard::rtps
