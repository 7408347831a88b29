// SPDX-License-Identifier: Apache-2.0
// How a node finds and reaches the others over the network.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/result.hpp"

namespace skein::blackboard {

/// Which DDS carries the samples. Nodes of both work together in one system.
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
  /// Whether others are looked for by multicast, and heard so. Those on this machine are looked for
  /// by unicast on the loopback interface, and on all others if there is no multicast.
  bool multicast = true;
  /// Where else others are looked for: "10.0.0.2" (the first eight programs of that machine) or
  /// "10.0.0.2:9160" (the program that has this port). One of two that are to meet must name the
  /// other.
  std::vector<std::string> peers;
  /// Discovery servers, "10.0.0.1:11811", in the order of their ids (0, 1, …). If there is one,
  /// others are found through it alone: neither multicast nor peers count. Fast DDS only.
  std::vector<std::string> discovery_servers;
  /// Folder with the keys of this node (scripts/make-keys); empty: anybody may take part. Fast
  /// DDS only.
  std::string keys;
};

struct NetworkAddress {
  std::string address;  ///< IPv4
  unsigned port = 0;    ///< 0: none was given
};

/// "10.0.0.2" or "10.0.0.2:9160".
Result<NetworkAddress, Failure> parse_address(std::string_view text);

/// Every address of the configuration that is none, and what the DDS that is chosen cannot do, one
/// sentence each.
std::vector<std::string> problems_of(const NetworkConfig& network);

}  // namespace skein::blackboard
