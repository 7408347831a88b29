// SPDX-License-Identifier: Apache-2.0
// Transfer of packets between tunnels.
#pragma once

#include <queue>
#include <vector>

#include "skein/air/air.hpp"
#include "skein/air/packet.hpp"
#include "tunnel.hpp"

namespace skein::air {

/// Moves packets between the tunnels, one for each node, with the delays and losses of the Air.
/// Times are steady.
class Carrier {
 public:
  Carrier(Air& air, std::vector<Tunnel> tunnels) : air_(air), tunnels_(std::move(tunnels)) {}

  const std::vector<Tunnel>& tunnels() const { return tunnels_; }
  /// Takes all packets that wait in the tunnel of this node.
  void take_from(std::size_t node, Duration now);
  void deliver(Duration now);
  /// When deliver() has a packet to deliver; nothing if none is under way.
  std::optional<Duration> next() const;

 private:
  struct Flight {
    Duration arrives;
    std::uint64_t number;  ///< in the order they were sent
    std::size_t from, to;
    std::vector<std::uint8_t> packet;
    bool operator<(const Flight& other) const {  // the earliest on top
      return std::tie(other.arrives, other.number) < std::tie(arrives, number);
    }
  };
  void send(std::size_t from, std::size_t to, const Route& route,
            const std::vector<std::uint8_t>& packet, Duration now);

  Air& air_;
  std::vector<Tunnel> tunnels_;
  std::priority_queue<Flight> flights_;
  std::uint64_t sent_ = 0;
};

}  // namespace skein::air
