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
  /// Of these what `from` may pass on for others; empty: it is no relay.
  std::vector<wire::Slot> relayed{};
  /// Of these what is on its way between others only: `from` has nothing of it to say to `to`.
  std::vector<wire::Slot> passing{};
  bool carries(wire::Slot slot) const;
  bool relays(wire::Slot slot) const;
  /// Whether `from` may say it to `to`.
  bool originates(wire::Slot slot) const;
};

/// A node as a channel names it.
struct Node {
  NodeNumber number;
  std::string name;  ///< of letters, digits, '-' and '_'
};

class SlotTable;

/// The two directions of a radio link, with what goes between two UAVs; here as below the table
/// says what that is, the one that ships if none is given.
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
/// In all its slots.
ChannelConfig world_channel();

/// How long so many bytes take at a capacity [bit/s] > 0.
Duration airtime(std::size_t bytes, double capacity);
/// Bytes that a sample takes of a channel: its encoding, and what carries it (RTPS with its
/// timestamp and destination, UDP, IP).
std::size_t channel_bytes(const wire::Sample& sample);
/// Those of any heartbeat.
std::size_t heartbeat_bytes();

/// What a radio channel carries besides, when one of its ends, or both, are relays: whatever any
/// other node may have for the far end (ends.from), or this one for any other (ends.to).
struct RelayEnds {
  bool from = false;
  bool to = false;
  bool to_station = false;  ///< it ends at the ground station
  bool from_station = false;
};
void add_relayed(ChannelConfig& channel, const RelayEnds& ends);
void add_relayed(ChannelConfig& channel, const RelayEnds& ends, const SlotTable& table);

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
