// SPDX-License-Identifier: Apache-2.0
// Which channels the transport should have connected, and what it is given to write.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// Connects and disconnects channels, asks again where the transport refuses, and names each thing
/// that it refuses once until it takes it. Thread rule: one thread.
class Connections {
 public:
  /// `again`: steady time between two attempts.
  Connections(Transport& transport, const std::vector<ChannelConfig>& channels, Duration again)
      : transport_(transport), channels_(channels), again_(again) {}

  void set_up(std::size_t channel, bool up, Duration now, std::vector<Incoming>& out);
  /// Asks again for what is due.
  void update(Duration now, std::vector<Incoming>& out);
  std::optional<Duration> next_due() const;
  /// Writes; a state that the transport does not take is tried again by write_again().
  void write(std::size_t channel, const wire::Sample& sample, std::vector<Incoming>& out);
  void write_again();
  /// The transport took a sample, or did not.
  void wrote(std::size_t channel, wire::Slot slot, bool taken, std::vector<Incoming>& out);

 private:
  struct Wanted {
    bool up = true;
    Duration due;
    bool named = false;
  };
  /// Channel, slot, origin, destination, instance.
  using StateKey = std::tuple<std::size_t, wire::Slot, std::uint32_t, std::uint32_t, std::uint32_t>;
  void ask(std::size_t channel, Wanted& wanted, Duration now, std::vector<Incoming>& out);

  Transport& transport_;
  const std::vector<ChannelConfig>& channels_;
  Duration again_;
  std::map<std::size_t, Wanted> refused_;
  std::set<std::pair<std::size_t, wire::Slot>> not_taken_;
  std::map<StateKey, wire::Sample> unwritten_;
};

}  // namespace skein::blackboard
