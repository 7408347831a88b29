// SPDX-License-Identifier: Apache-2.0
// What of an IPv4 packet says where it goes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace skein::air {

struct Route {
  std::uint32_t to = 0;    ///< address, in host order
  bool everybody = false;  ///< multicast, or broadcast
  bool piece = false;      ///< IP fragment
  bool operator==(const Route&) const = default;
};

/// The route of a packet; nothing if it is not a complete IPv4 packet.
std::optional<Route> route_of(std::span<const std::uint8_t> packet);

/// The address of the node with this index: 10.99.0.1 for the first.
std::uint32_t address_of(std::size_t node);
/// The index of the node with this address; nothing if no node can have it.
std::optional<std::size_t> node_of(std::uint32_t address);
std::string to_text(std::uint32_t address);

}  // namespace skein::air
