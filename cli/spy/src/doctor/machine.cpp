// SPDX-License-Identifier: Apache-2.0
#include "machine.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace skein::spy_tool {

namespace {

namespace fs = std::filesystem;

constexpr const char* kGroup = "239.255.0.1";  ///< of RTPS discovery
constexpr int kWaits = 500;                    ///< [ms] for a packet of one's own

std::vector<Interface> interfaces() {
  std::vector<Interface> found;
  ifaddrs* all = nullptr;
  if (getifaddrs(&all) != 0) return found;
  for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
    if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET) continue;
    sockaddr_in address{};
    std::memcpy(&address, one->ifa_addr, sizeof address);
    char text[INET_ADDRSTRLEN];
    inet_ntop(AF_INET, &address.sin_addr, text, sizeof text);
    found.push_back({one->ifa_name, text, (one->ifa_flags & IFF_UP) != 0,
                     (one->ifa_flags & IFF_MULTICAST) != 0, (one->ifa_flags & IFF_LOOPBACK) != 0});
  }
  freeifaddrs(all);
  return found;
}

std::uint64_t number_in(const char* file) {
  std::ifstream in(file);
  std::uint64_t number = 0;
  in >> number;
  return number;
}

/// Of the two lines "Udp: …" of /proc/net/snmp.
std::uint64_t udp_overflows() {
  std::ifstream in("/proc/net/snmp");
  std::vector<std::string> names;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("Udp:")) continue;
    std::istringstream words(line);
    const std::vector<std::string> all{std::istream_iterator<std::string>(words), {}};
    if (names.empty()) {
      names = all;
      continue;
    }
    const auto at =
        static_cast<std::size_t>(std::ranges::find(names, "RcvbufErrors") - names.begin());
    return at < all.size() ? std::stoull(all[at]) : 0;
  }
  return 0;
}

void add_used_by(const fs::path& process, const std::string& folder, std::set<std::string>& used) {
  std::error_code gone;
  for (const auto& open : fs::directory_iterator(process / "fd", gone)) {
    const std::string file = fs::read_symlink(open.path(), gone).string();
    if (file.starts_with(folder)) used.insert(file.substr(folder.size()));
  }
  std::ifstream maps(process / "maps");
  for (std::string line; std::getline(maps, line);) {
    const std::size_t at = line.find(folder);
    if (at != std::string::npos) used.insert(line.substr(at + folder.size()));
  }
}

Leftovers leftovers(const std::string& shared_memory) {
  const std::string folder = shared_memory + "/";
  std::set<std::string> used;
  std::error_code none;
  for (const auto& process : fs::directory_iterator("/proc", none)) {
    const std::string name = process.path().filename().string();
    if (name.find_first_not_of("0123456789") == std::string::npos)
      add_used_by(process.path(), folder, used);
  }
  Leftovers left;
  for (const auto& file : fs::directory_iterator(shared_memory, none)) {
    const std::string name = file.path().filename().string();
    const bool ours = name.starts_with("fastrtps_") || name.starts_with("fastdds_") ||
                      name.starts_with("sem.fastrtps_") || name.starts_with("sem.fastdds_");
    if (!ours || used.contains(name)) continue;
    left.names.push_back(name);
    left.bytes += fs::is_regular_file(file.path(), none) ? fs::file_size(file.path(), none) : 0;
  }
  std::ranges::sort(left.names);
  return left;
}

template <class Clock>
std::int64_t now_of() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch())
      .count();
}

/// Closed with it.
class Socket {
 public:
  Socket() : number_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket() {
    if (number_ >= 0) close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

MachineFacts look_at_machine(const std::string& shared_memory) {
  MachineFacts facts;
  facts.interfaces = interfaces();
  facts.receive_buffer = number_in("/proc/sys/net/core/rmem_max");
  facts.overflows = udp_overflows();
  facts.leftovers = leftovers(shared_memory);
  facts.wall = now_of<std::chrono::system_clock>();
  facts.steady = now_of<std::chrono::steady_clock>();
  return facts;
}

Result<void, Failure> try_multicast(const std::string& address) {
  const auto refused = [](const std::string& what) {
    return failure(what + ": " + std::strerror(errno));
  };
  const Socket ear, mouth;
  sockaddr_in any{};
  any.sin_family = AF_INET;
  ip_mreqn group{};
  if (inet_pton(AF_INET, address.c_str(), &group.imr_address) != 1)
    return failure("'" + address + "' is no IPv4 address");
  inet_pton(AF_INET, kGroup, &group.imr_multiaddr);
  if (bind(ear.number(), reinterpret_cast<const sockaddr*>(&any), sizeof any) != 0)
    return refused("no port");
  if (setsockopt(ear.number(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group) != 0)
    return refused("the group " + std::string(kGroup) + " cannot be joined");
  if (setsockopt(mouth.number(), IPPROTO_IP, IP_MULTICAST_IF, &group, sizeof group) != 0)
    return refused("multicast cannot be sent");
  sockaddr_in to{};
  socklen_t length = sizeof to;
  getsockname(ear.number(), reinterpret_cast<sockaddr*>(&to), &length);
  to.sin_addr = group.imr_multiaddr;
  const std::string word = "skein " + std::to_string(now_of<std::chrono::steady_clock>());
  if (sendto(mouth.number(), word.data(), word.size(), 0, reinterpret_cast<const sockaddr*>(&to),
             sizeof to) < 0)
    return refused("multicast cannot be sent");
  pollfd waits{ear.number(), POLLIN, 0};
  if (poll(&waits, 1, kWaits) < 1) return failure("what is sent does not come back");
  return {};
}

}  // namespace skein::spy_tool
