// SPDX-License-Identifier: Apache-2.0
// Model of the radio between several nodes: delay, loss and rate of packets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "skein/foundation/time.hpp"

namespace skein::air {

/// The condition of one direction between two nodes.
struct Condition {
  bool up = true;
  double loss = 0;  ///< share of packets that are lost, in [0, 1]
  Duration delay;   ///< added to the transmission time of a packet
  double rate = 0;  ///< [byte/s]; 0: unlimited
  bool operator==(const Condition&) const = default;
};

/// Counts of the packets of one direction.
struct Counts {
  std::uint64_t carried = 0;
  std::uint64_t bytes = 0;       ///< of those carried
  std::uint64_t lost = 0;        ///< by chance
  std::uint64_t cut = 0;         ///< the link was down
  std::uint64_t overflowed = 0;  ///< lost because the queue was full
  std::uint64_t pieces = 0;      ///< IP fragments among all packets sent
  bool operator==(const Counts&) const = default;
};

/// Every ordered pair of nodes is a channel of its own: packets keep their order and are sent one
/// after the other at its rate from a queue; a packet that would wait for longer than
/// `longest_queue` is lost. The same seed and calls give the same losses. Reads no clock: `now`
/// must not decrease.
class Air {
 public:
  Air(std::size_t nodes, std::uint64_t seed, Duration longest_queue = Duration::milliseconds(2000));

  std::size_t nodes() const { return nodes_; }
  void set(std::size_t from, std::size_t to, const Condition& condition);
  const Condition& condition(std::size_t from, std::size_t to) const;
  /// Sends a packet; returns when it arrives, or nothing if it is lost.
  std::optional<Duration> send(std::size_t from, std::size_t to, std::size_t bytes, Duration now);
  /// To be called at a packet's arrival time: whether it really arrives. Packets under way when the
  /// link is cut do not.
  bool arrives(std::size_t from, std::size_t to, std::size_t bytes);
  /// Counts the packet given to send() as an IP fragment (a datagram is lost with any fragment).
  void note_piece(std::size_t from, std::size_t to) { ++at(from, to).counts.pieces; }
  const Counts& counts(std::size_t from, std::size_t to) const;

 private:
  struct Channel {
    Condition condition;
    Counts counts;
    Duration free;  ///< from when on the next packet can go out
    Duration last;  ///< when the last one arrives
  };
  Channel& at(std::size_t from, std::size_t to) { return channels_[from * nodes_ + to]; }

  std::size_t nodes_;
  Duration longest_queue_;
  std::vector<Channel> channels_;
  std::mt19937_64 random_;
};

}  // namespace skein::air
