// SPDX-License-Identifier: Apache-2.0
// Radio links between nodes.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/time.hpp"

namespace skein::spy_tool {

/// One direction between two nodes, with the available statements about it.
struct Link {
  std::uint32_t from = 0, to = 0;
  std::optional<Duration> heartbeat;     ///< steady time of the last heartbeat in this direction
  std::optional<double> period;          ///< [s] between the last two
  std::optional<bool> heard;             ///< link state according to the receiver
  std::optional<bool> carried;           ///< link state according to the simulator
  std::optional<std::uint64_t> waiting;  ///< events sent and not acknowledged
};

/// Derives links from heartbeats (with their acknowledgements), the receivers' statements (slots
/// Neighbours and UavBoard, records `reach` of the event log) and those of the simulator. Of two
/// processes with one name it is the one that others acknowledge. A value type without a clock.
class Links {
 public:
  void hear(const wire::Sample& sample, Duration at);
  /// All links with a heartbeat or a statement, by sender, then receiver.
  std::vector<Link> all() const;

 private:
  struct Half {
    Link link;
    std::uint64_t incarnation = 0;  ///< of the sender
    std::uint64_t sent = 0;         ///< its last event
    std::uint64_t acknowledged_incarnation = 0, acknowledged = 0;
  };
  /// The process that is taken for a node.
  struct Life {
    std::uint64_t incarnation = 0;
    std::optional<Duration> heard;
  };
  Half& half(std::uint32_t from, std::uint32_t to);
  /// Whether another process of its sender is taken for that, and is not silent.
  bool is_of_second(const wire::SampleHeader& header, Duration at);
  void hear_heartbeat(const wire::Heartbeat& heartbeat, Duration at);
  void hear_record(const wire::JournalEntry& entry);
  /// Takes a sample that lists the nodes that its origin hears.
  void hear_neighbours(const wire::Sample& sample);

  std::map<std::pair<std::uint32_t, std::uint32_t>, Half> halves_;
  std::map<std::string, std::uint32_t> numbers_;  ///< by name
  std::map<std::uint32_t, Life> lives_;           ///< by node, as far as acknowledged by another
};

}  // namespace skein::spy_tool
