// SPDX-License-Identifier: Apache-2.0
#include "carrier.hpp"

namespace skein::air {

void Carrier::take_from(std::size_t node, Duration now) {
  for (auto packet = tunnels_[node].read(); !packet.empty(); packet = tunnels_[node].read()) {
    const auto route = route_of(packet);
    if (!route) continue;  // IPv6, for one
    if (route->everybody) {
      for (std::size_t to = 0; to < air_.nodes(); ++to)
        if (to != node) send(node, to, *route, packet, now);
    } else if (const auto to = node_of(route->to); to && *to < air_.nodes() && *to != node) {
      send(node, *to, *route, packet, now);
    }
  }
}

void Carrier::send(std::size_t from, std::size_t to, const Route& route,
                   const std::vector<std::uint8_t>& packet, Duration now) {
  if (route.piece) air_.note_piece(from, to);
  if (const auto arrives = air_.send(from, to, packet.size(), now))
    flights_.push({*arrives, ++sent_, from, to, packet});
}

void Carrier::deliver(Duration now) {
  while (!flights_.empty() && flights_.top().arrives <= now) {
    const Flight& flight = flights_.top();
    if (air_.arrives(flight.from, flight.to, flight.packet.size()))
      (void)tunnels_[flight.to].write(flight.packet);
    flights_.pop();
  }
}

std::optional<Duration> Carrier::next() const {
  return flights_.empty() ? std::nullopt : std::optional(flights_.top().arrives);
}

}  // namespace skein::air
