// SPDX-License-Identifier: Apache-2.0
// The longest datagram that the network carries without IP fragmentation.
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

/// The least that RTPS needs for one submessage with content [byte].
inline constexpr std::uint32_t kShortestDatagram = 1024;
/// The longest datagram of Fast DDS, whatever the network carries [byte].
inline constexpr std::uint32_t kLongestDatagram = 65'500;

}  // namespace skein::blackboard::rtps
