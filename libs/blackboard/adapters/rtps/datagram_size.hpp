// SPDX-License-Identifier: Apache-2.0
// How long a datagram may be that the network does not cut up.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace skein::blackboard::rtps {

/// The bytes that an interface with this IPv4 address carries in one packet; none: there is none.
using PacketSizeOf = std::function<std::optional<std::uint32_t>(const std::string& address)>;

/// The longest UDP datagram [byte] that all interfaces with these IPv4 addresses carry in one
/// packet: of what goes in two, each of which is lost by itself, nothing comes when one is lost.
/// Between kShortestDatagram and kLongestDatagram; the longest for addresses that no interface has.
/// Cost: a system call each. Source: RFC 791, RFC 768 (20 bytes of IP and 8 of UDP).
std::uint32_t longest_datagram(const std::vector<std::string>& addresses,
                               const PacketSizeOf& packet_size_of);
/// Asks the system for the interfaces' sizes.
std::uint32_t longest_datagram(const std::vector<std::string>& addresses);

/// What RTPS needs for one submessage with something in it.
inline constexpr std::uint32_t kShortestDatagram = 1024;
/// What Fast DDS says at most, whatever the network carries.
inline constexpr std::uint32_t kLongestDatagram = 65'500;

}  // namespace skein::blackboard::rtps
