// SPDX-License-Identifier: Apache-2.0
// The UDP ports of DDS domains and participants, and the addresses of this machine.
#include "ports.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

#include "skein/foundation/joined.hpp"

namespace skein::blackboard::rtps {

std::set<unsigned> bound_udp_ports() {
  std::set<unsigned> ports;
  for (const char* table : {"/proc/net/udp", "/proc/net/udp6"}) {
    std::ifstream in(table);
    std::string line;
    std::getline(in, line);  // headings
    while (std::getline(in, line)) {
      std::istringstream words(line);
      std::string number;
      std::string local;  // address:port, both hexadecimal
      words >> number >> local;
      const auto colon = local.rfind(':');
      if (colon == std::string::npos) continue;
      ports.insert(static_cast<unsigned>(std::strtoul(local.c_str() + colon + 1, nullptr, 16)));
    }
  }
  return ports;
}

std::set<std::string> own_addresses() {
  std::set<std::string> addresses;
  ifaddrs* all = nullptr;
  if (getifaddrs(&all) != 0) return addresses;
  for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
    // DDS leaves out an interface without a carrier, and does not look again.
    const bool up = (one->ifa_flags & IFF_UP) != 0 && (one->ifa_flags & IFF_RUNNING) != 0;
    if (!up || one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET) continue;
    sockaddr_in address{};
    std::memcpy(&address, one->ifa_addr, sizeof address);
    char text[INET_ADDRSTRLEN];
    inet_ntop(AF_INET, &address.sin_addr, text, sizeof text);
    addresses.emplace(text);
  }
  freeifaddrs(all);
  return addresses;
}

Result<void, Failure> check(const NetworkConfig& network) {
  std::vector<std::string> problems = problems_of(network);
  const std::set<std::string> own = own_addresses();
  for (const std::string& address : network.interfaces) {
    if (own.contains(address)) continue;
    problems.push_back("no interface that is up has address " + address);
  }
  if (problems.empty()) return {};
  return failure(joined(problems, "; "));
}

std::vector<NetworkAddress> places_to_look(const NetworkConfig& network, std::uint32_t domain) {
  std::vector<NetworkAddress> places;
  const auto look_at = [&](const std::string& address, std::uint32_t participants) {
    for (std::uint32_t one = 0; one < participants; ++one) {
      places.push_back({address, first_port(domain, one)});
    }
  };
  for (const std::string& text : network.peers) {
    const auto peer = parse_address(text);
    if (!peer) continue;  // refused before
    if (peer->port == 0) {
      look_at(peer->address, kTriedOfPeer);
    } else {
      places.push_back(*peer);
    }
  }
  // On this machine a loopback interface need not have multicast.
  for (const std::string& address : network.interfaces) {
    if (address == kLoopback) look_at(address, kParticipants);
    if (address != kLoopback && !network.multicast) look_at(address, kTriedOfPeer);
  }
  return places;
}

}  // namespace skein::blackboard::rtps
