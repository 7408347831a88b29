// SPDX-License-Identifier: Apache-2.0
// What a radio does to the packets of several nodes, without any packet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "skein/foundation/time.hpp"

namespace skein::air {

/// Of one direction between two nodes.
struct Condition {
  bool up = true;
  double loss = 0;  ///< share of packets that vanish, in [0, 1]
  Duration delay;   ///< besides the time that a packet takes at the rate
  double rate = 0;  ///< [byte/s]; 0: any
  bool operator==(const Condition&) const = default;
};

/// What became of packets.
struct Counts {
  std::uint64_t carried = 0;
  std::uint64_t bytes = 0;       ///< of those carried
  std::uint64_t lost = 0;        ///< by chance
  std::uint64_t cut = 0;         ///< the link was down
  std::uint64_t overflowed = 0;  ///< more waited than the queue holds
  std::uint64_t pieces = 0;      ///< of all: of datagrams that did not fit into one packet
  bool operator==(const Counts&) const = default;
};

/// Every ordered pair of nodes is a channel of its own: packets keep their order, go out at its
/// rate one after the other from a queue that holds `longest_queue` of them in time, and what does
/// not fit is lost. One seed and the same calls give the same losses. No clock: time is given, and
/// does not decrease.
class Air {
 public:
  Air(std::size_t nodes, std::uint64_t seed, Duration longest_queue = Duration::milliseconds(2000));

  std::size_t nodes() const { return nodes_; }
  void set(std::size_t from, std::size_t to, const Condition& condition);
  const Condition& condition(std::size_t from, std::size_t to) const;
  /// When it arrives; nothing if it does not.
  std::optional<Duration> send(std::size_t from, std::size_t to, std::size_t bytes, Duration now);
  /// It is its time: whether it really arrives. What is under way when a link is cut does not.
  bool arrives(std::size_t from, std::size_t to, std::size_t bytes);
  /// What was given to send() was a piece of a datagram: it is lost with any other of its pieces.
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
