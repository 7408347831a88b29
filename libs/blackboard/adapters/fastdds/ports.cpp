// SPDX-License-Identifier: Apache-2.0
// The UDP ports of DDS domains and participants.
#include "ports.hpp"

#include <cstdlib>
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

}  // namespace skein::blackboard::fastdds
