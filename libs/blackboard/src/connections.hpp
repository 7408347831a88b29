// SPDX-License-Identifier: Apache-2.0
// Connection of channels and writing of samples, with repetition of what the transport refuses.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// Connects and disconnects channels, retries what the transport refuses, and reports each refusal
/// once (TransportRefused) until it succeeds. Thread rule: one thread.
class Connections {
 public:
  /// `again`: steady time between two attempts.
  Connections(Transport& transport, const std::vector<ChannelConfig>& channels, Duration again)
      : transport_(transport), channels_(channels), again_(again) {}

  void set_up(std::size_t channel, bool up, Duration now, std::vector<Incoming>& out);
  /// Down and up: the transport then gives the last values on the channel again.
  void set_up_anew(std::size_t channel, Duration now, std::vector<Incoming>& out) {
    set_up(channel, false, now, out);
    set_up(channel, true, now, out);
  }
  /// Retries the connections and disconnections that are due.
  void update(Duration now, std::vector<Incoming>& out);
  std::optional<Duration> next_due() const;
  /// Writes a sample. A state that the transport does not accept is kept for write_again().
  void write(std::size_t channel, const wire::Sample& sample, std::vector<Incoming>& out);
  void write_again();
  /// Notes whether the transport accepted a sample.
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
