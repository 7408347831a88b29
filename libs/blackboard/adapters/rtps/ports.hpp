// SPDX-License-Identifier: Apache-2.0
// The UDP ports of DDS domains and participants, and the addresses of this machine.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "skein/blackboard/network.hpp"
#include "skein/foundation/result.hpp"

namespace skein::blackboard::rtps {

/// Source: RTPS 2.3, 9.6.1.1, with the default parameters: domain d starts at 7400 + 250 d; its
/// participant p has two ports from 10 + 2 p after that.
constexpr unsigned first_port(std::uint32_t domain) { return 7400 + 250 * domain; }
constexpr unsigned first_port(std::uint32_t domain, std::uint32_t participant) {
  return first_port(domain) + 10 + 2 * participant;
}
inline constexpr unsigned kPortsPerDomain = 250;
/// Above, ports reach into the range that the kernel gives to anybody (32768 and up).
inline constexpr std::uint32_t kLastDomain = 100;
/// Participants per machine, and the ports that discovery tries on this machine: a team of 32 with
/// its ground station and some programs that watch them.
inline constexpr std::uint32_t kParticipants = 40;
/// Participants that are looked for on a peer's machine, and on this one at other addresses than
/// the loopback's.
inline constexpr std::uint32_t kTriedOfPeer = 8;
inline constexpr const char* kLoopback = "127.0.0.1";

/// UDP ports bound in this network namespace.
std::set<unsigned> bound_udp_ports();

/// IPv4 addresses of this machine's interfaces that are up, as text.
std::set<std::string> own_addresses();

/// What is wrong with the configuration, or with this machine for it: middlewares take an address
/// that nobody has, and then are deaf.
Result<void, Failure> check(const NetworkConfig& network);

/// Where a participant knocks to find others, besides by multicast: at the peers, and on this
/// machine. Each has a port.
std::vector<NetworkAddress> places_to_look(const NetworkConfig& network, std::uint32_t domain);

}  // namespace skein::blackboard::rtps
