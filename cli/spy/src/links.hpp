// SPDX-License-Identifier: Apache-2.0
// Who hears whom.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/time.hpp"

namespace skein::spy_tool {

/// One direction between two nodes, as far as anybody says something of it.
struct Link {
  std::uint32_t from = 0, to = 0;
  std::optional<Duration> heartbeat;     ///< steady; the last one from the one to the other
  std::optional<double> period;          ///< [s] between the last two
  std::optional<bool> heard;             ///< the receiver says so
  std::optional<bool> carried;           ///< the simulator says so
  std::optional<std::uint64_t> waiting;  ///< events sent and not acknowledged
};

/// From heartbeats (by what they acknowledge), the receivers' own words (slots Neighbours and
/// UavBoard, records `reach` of the event log) and the simulator's. Only values, no clock.
class Links {
 public:
  void hear(const wire::Sample& sample, Duration at);
  /// By sender, then receiver; those of which a heartbeat or a word was heard.
  std::vector<Link> all() const;

 private:
  struct Half {
    Link link;
    std::uint64_t incarnation = 0;  ///< of the sender
    std::uint64_t sent = 0;         ///< its last event
    std::uint64_t acknowledged_incarnation = 0, acknowledged = 0;
  };
  Half& half(std::uint32_t from, std::uint32_t to);
  void hear_heartbeat(const wire::Heartbeat& heartbeat, Duration at);
  void hear_record(const wire::JournalEntry& entry);
  /// Of a slot that says whom its origin hears.
  void hear_neighbours(const wire::Sample& sample);

  std::map<std::pair<std::uint32_t, std::uint32_t>, Half> halves_;
  std::map<std::string, std::uint32_t> numbers_;  ///< by name
};

}  // namespace skein::spy_tool
