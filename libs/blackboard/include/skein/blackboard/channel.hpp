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
/// As a destination: all nodes. No node has this number.
inline constexpr NodeNumber kEverybody{0};

/// The two time scales of a blackboard. Mission time stands still before the start and after the
/// end of the mission; only expiry uses it. Everything else uses steady time: monotonic, from any
/// origin (the steady clock of a daemon; virtual time in the virtual runtime).
struct Now {
  MissionTime mission;
  Duration steady;
};

/// radio: between two nodes, cut and delayed by the radio model; onboard: between a DDN and the
/// simulator of its vehicle; world: everybody to everybody, never cut. Source: spec 1.3.
enum class ChannelKind : std::uint8_t { kRadio, kOnboard, kWorld };
std::string_view name_of(ChannelKind kind);

/// A directed channel. A node's configuration has the channels that start or end at it; between two
/// nodes there is at most one in each direction. The world is one channel; its `from` and `to` are
/// ignored.
struct ChannelConfig {
  NodeNumber from;
  NodeNumber to;
  ChannelKind kind = ChannelKind::kRadio;
  std::string partition;          ///< the DDS partition: "radio/marvin>ground"
  std::vector<wire::Slot> slots;  ///< the slots that it carries, besides the heartbeat
  /// Limit on what is written [bit/s of steady time] while no ChannelCondition gives another; 0:
  /// unlimited. Keeps a node from overloading a real radio.
  double capacity = 0;
  /// The subset of `slots` that `from` may forward for other nodes; empty: `from` is no relay.
  std::vector<wire::Slot> relayed{};
  /// The subset of `slots` that is only forwarded: `from` sends no samples of its own in them.
  std::vector<wire::Slot> passing{};
  bool carries(wire::Slot slot) const;
  bool relays(wire::Slot slot) const;
  /// Whether `from` may send samples of its own in this slot.
  bool originates(wire::Slot slot) const;
};

/// A node as channels and partitions name it.
struct Node {
  NodeNumber number;
  std::string name;  ///< of letters, digits, '-' and '_'
};

class SlotTable;

/// The two directions of a radio link between two UAVs. Here and below `table` gives the slots;
/// without it SlotTable::shipped() does.
std::vector<ChannelConfig> radio_link(const Node& a, const Node& b);
std::vector<ChannelConfig> radio_link(const Node& a, const Node& b, const SlotTable& table);
/// The radio link between the ground station and a UAV.
std::vector<ChannelConfig> station_link(const Node& station, const Node& uav);
std::vector<ChannelConfig> station_link(const Node& station, const Node& uav,
                                        const SlotTable& table);
/// The two directions between the DDN of `uav` and its simulated vehicle; partition
/// "onboard/<uav>".
std::vector<ChannelConfig> onboard_link(const Node& uav, const Node& simulator);
std::vector<ChannelConfig> onboard_link(const Node& uav, const Node& simulator,
                                        const SlotTable& table);
/// The world channel with all its slots.
ChannelConfig world_channel();

/// The time to transmit this many bytes at a capacity [bit/s] > 0.
Duration airtime(std::size_t bytes, double capacity);
/// Bytes that a sample takes on a channel: its encoding and the overhead of the protocols (RTPS
/// with timestamp and destination, UDP, IP).
std::size_t channel_bytes(const wire::Sample& sample);
/// channel_bytes() of any heartbeat.
std::size_t heartbeat_bytes();

/// Which ends of a radio channel are relays, and which is the ground station.
struct RelayEnds {
  bool from = false;  ///< the sender is a relay
  bool to = false;    ///< the receiver is a relay
  bool to_station = false;
  bool from_station = false;
};
/// Adds the slots that the channel carries because of relays: those of any other node for its
/// receiver (if ends.from), and those of its sender for any other node (if ends.to).
void add_relayed(ChannelConfig& channel, const RelayEnds& ends);
void add_relayed(ChannelConfig& channel, const RelayEnds& ends, const SlotTable& table);

/// The condition of a directed channel. Both its sender and its receiver are told, so that a cut
/// takes effect at both sides.
struct ChannelCondition {
  bool up = true;
  /// Delay before delivery, in steady time: at scenario rate r, the latency in mission time / r.
  Duration latency;
  double loss = 0;      ///< share of stream samples that are lost, in [0, 1]
  double capacity = 0;  ///< [bit/s of steady time]; 0: ChannelConfig::capacity holds
  bool operator==(const ChannelCondition&) const = default;
};

}  // namespace skein::blackboard
