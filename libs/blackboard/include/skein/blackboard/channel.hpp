// SPDX-License-Identifier: Apache-2.0
// Nodes and the channels between them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/id.hpp"
#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// The number of a node in the system; names travel in the DirectoryEntry slot.
using NodeNumber = Id<struct NodeNumberTag, std::uint32_t>;
/// As a destination: everybody. No node has this number.
inline constexpr NodeNumber kEverybody{0};

/// The two times a blackboard lives by. Mission time stands still before the start and at the end,
/// so expiry runs on it and everything else on steady time: that of the transport, monotonic, from
/// any origin (the wall clock of a daemon; virtual time in the virtual runtime).
struct Now {
  MissionTime mission;
  Duration steady;
};

/// radio: between two nodes, cut and delayed by the radio model; onboard: between a DDN and the
/// simulator of its vehicle; world: everybody to everybody, never cut. Source: spec 1.3.
enum class ChannelKind : std::uint8_t { kRadio, kOnboard, kWorld };
std::string_view name_of(ChannelKind kind);

/// A directed channel. Each node has those that start or end at it; between two nodes there is at
/// most one in each direction. The world is one channel, whose ends do not count.
struct ChannelConfig {
  NodeNumber from;
  NodeNumber to;
  ChannelKind kind = ChannelKind::kRadio;
  std::string partition;          ///< the DDS partition: "radio/marvin>ground"
  std::vector<wire::Slot> slots;  ///< that it carries, besides the heartbeat
  /// As long as nobody tells another condition of it, no more is written than this [bit/s], in
  /// steady time; 0: unlimited. So a node does not ask too much of a real radio.
  double capacity = 0;
};

/// A node as a channel names it.
struct Node {
  NodeNumber number;
  std::string name;  ///< of letters, digits, '-' and '_'
};

/// The two directions of a radio link, with the slots that go over radio.
std::vector<ChannelConfig> radio_link(const Node& a, const Node& b);
/// The radio link between the ground station and a UAV: the same, and commands up, what the UAV
/// says of its deliberation down.
std::vector<ChannelConfig> station_link(const Node& station, const Node& uav);
/// The two directions between the DDN of `uav` and its simulated vehicle; partition
/// "onboard/<uav>".
std::vector<ChannelConfig> onboard_link(const Node& uav, const Node& simulator);
ChannelConfig world_channel();

/// How long so many bytes take at a capacity [bit/s] > 0.
Duration airtime(std::size_t bytes, double capacity);
/// Bytes that a sample takes of a channel: its encoding, and what carries it (RTPS with its
/// timestamp and destination, UDP, IP).
std::size_t channel_bytes(const wire::Sample& sample);
/// Those of any heartbeat.
std::size_t heartbeat_bytes();

/// What a directed channel does to what is sent over it. The node that sends and the node that
/// receives are both told, so that a cut holds from both sides.
struct ChannelCondition {
  bool up = true;
  /// Added before delivery, in steady time: at a scenario rate r, the mission's latency / r.
  Duration latency;
  double loss = 0;      ///< share of stream samples that vanish, in [0, 1]
  double capacity = 0;  ///< [bit/s], likewise in steady time; 0: what the channel declares
  bool operator==(const ChannelCondition&) const = default;
};

}  // namespace skein::blackboard
