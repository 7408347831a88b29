// SPDX-License-Identifier: Apache-2.0
// Network configuration of a node: DDS vendor, interfaces, discovery, keys.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/result.hpp"

namespace skein::blackboard {

/// The DDS implementation that carries the samples. Nodes of both interoperate in one system.
enum class DdsVendor : std::uint8_t { kFastDds, kCycloneDds };
/// "fastdds", "cyclonedds".
std::string_view name_of(DdsVendor vendor);
std::optional<DdsVendor> dds_from_name(std::string_view name);
/// All names, in the order of the enumeration.
std::vector<std::string> dds_names();

struct NetworkConfig {
  DdsVendor dds = DdsVendor::kFastDds;
  /// Addresses of the interfaces to use, IPv4; the default stays on this machine.
  std::vector<std::string> interfaces = {"127.0.0.1"};
  /// Whether discovery uses multicast. Programs on this machine are also looked for by unicast on
  /// the loopback interface, and without multicast on all its other interfaces.
  bool multicast = true;
  /// Further addresses for discovery by unicast: "10.0.0.2" (the first eight programs of that
  /// machine) or "10.0.0.2:9160" (the program with this port). Of two programs without multicast at
  /// least one must name the other.
  std::vector<std::string> peers;
  /// Discovery servers, "10.0.0.1:11811", in the order of their ids (0, 1, …). If there are any,
  /// discovery uses nothing else: `multicast` and `peers` are ignored. Fast DDS only.
  std::vector<std::string> discovery_servers;
  /// Folder with the keys of this node (scripts/make-keys); empty: the domain is not secured. Fast
  /// DDS only.
  std::string keys;
  /// Whether the types of what this node writes are announced (XTypes), so that programs without
  /// our IDL can read it. Cyclone DDS only.
  bool types = false;
};

struct NetworkAddress {
  std::string address;  ///< IPv4
  unsigned port = 0;    ///< 0: not given
};

/// "10.0.0.2" or "10.0.0.2:9160".
Result<NetworkAddress, Failure> parse_address(std::string_view text);

/// All problems of the configuration, one sentence each: malformed addresses, and options that the
/// chosen DDS does not support.
std::vector<std::string> problems_of(const NetworkConfig& network);

}  // namespace skein::blackboard
