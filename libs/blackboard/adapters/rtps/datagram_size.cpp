// SPDX-License-Identifier: Apache-2.0
#include "datagram_size.hpp"

#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <memory>

#include "source_addresses.hpp"

namespace skein::blackboard::rtps {
namespace {

constexpr std::uint32_t kHeaders = 28;  ///< of IPv4 and UDP [byte]

std::optional<std::uint32_t> packet_size(const char* interface) {
  const int file = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (file < 0) return std::nullopt;
  ifreq request{};
  const std::string name(interface);
  std::copy_n(name.begin(), std::min(name.size(), std::size(request.ifr_name) - 1),
              std::begin(request.ifr_name));
  const bool known = ioctl(file, SIOCGIFMTU, &request) == 0 && request.ifr_mtu > 0;
  close(file);
  if (!known) return std::nullopt;
  return static_cast<std::uint32_t>(request.ifr_mtu);
}

std::optional<std::uint32_t> packet_size_at(const std::string& address) {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return std::nullopt;
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> all(first, freeifaddrs);
  const auto wanted = parse_ipv4(address);
  for (const ifaddrs* one = first; one != nullptr; one = one->ifa_next) {
    if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET) continue;
    const auto* const own = reinterpret_cast<const sockaddr_in*>(one->ifa_addr);
    if (wanted == ntohl(own->sin_addr.s_addr)) return packet_size(one->ifa_name);
  }
  return std::nullopt;
}

}  // namespace

std::uint32_t longest_datagram(const std::vector<std::string>& addresses,
                               const PacketSizeOf& packet_size_of) {
  std::uint32_t longest = kLongestDatagram;
  for (const std::string& address : addresses) {
    const auto packet = packet_size_of(address);
    if (!packet) continue;
    longest = std::min(longest, std::max(*packet, kHeaders) - kHeaders);
  }
  return std::max(longest, kShortestDatagram);
}

std::uint32_t longest_datagram(const std::vector<std::string>& addresses) {
  return longest_datagram(addresses, packet_size_at);
}

}  // namespace skein::blackboard::rtps
