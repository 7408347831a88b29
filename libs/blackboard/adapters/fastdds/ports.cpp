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

namespace skein::blackboard::fastdds {

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
    const bool up = (one->ifa_flags & IFF_UP) != 0;
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

}  // namespace skein::blackboard::fastdds
