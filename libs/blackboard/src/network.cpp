// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/network.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace skein::blackboard {
namespace {

constexpr std::array<std::string_view, 2> kNames{"fastdds", "cyclonedds"};

/// A decimal number without sign from `low` to `high` that is all of the text.
bool is_number(std::string_view text, unsigned low, unsigned high, unsigned& number) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end && number >= low && number <= high;
}

bool is_address(std::string_view text) {
  unsigned number = 0;
  for (int dots = 0; dots < 3; ++dots) {
    const std::size_t dot = text.find('.');
    if (dot == std::string_view::npos || !is_number(text.substr(0, dot), 0, 255, number)) {
      return false;
    }
    text.remove_prefix(dot + 1);
  }
  return is_number(text, 0, 255, number);
}

}  // namespace

std::string_view name_of(DdsVendor vendor) { return kNames[static_cast<std::size_t>(vendor)]; }

std::optional<DdsVendor> dds_from_name(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == name) return static_cast<DdsVendor>(i);
  return std::nullopt;
}

std::vector<std::string> dds_names() { return {kNames.begin(), kNames.end()}; }

Result<NetworkAddress, Failure> parse_address(std::string_view text) {
  const std::size_t colon = text.find(':');
  NetworkAddress parsed{std::string(text.substr(0, colon)), 0};
  const bool port = colon != std::string_view::npos;
  if (is_address(parsed.address) &&
      (!port || is_number(text.substr(colon + 1), 1, 65'535, parsed.port))) {
    return parsed;
  }
  return failure("'" + std::string(text) + "' is not an IPv4 address, or one with :PORT");
}

std::vector<std::string> problems_of(const NetworkConfig& network) {
  std::vector<std::string> problems;
  const auto check = [&](const char* what, const std::string& text, int ports) {
    const auto parsed = parse_address(text);
    if (!parsed) {
      problems.push_back(std::string(what) + " " + parsed.error().why);
    } else if (ports < 0 && parsed->port != 0) {
      problems.push_back(std::string(what) + " '" + text + "' has a port");
    } else if (ports > 0 && parsed->port == 0) {
      problems.push_back(std::string(what) + " '" + text + "' has no port");
    }
  };
  for (const std::string& one : network.interfaces) check("interface", one, -1);
  for (const std::string& one : network.peers) check("peer", one, 0);
  for (const std::string& one : network.discovery_servers) check("discovery server", one, 1);
  if (network.types && network.dds != DdsVendor::kCycloneDds) {
    problems.emplace_back(
        "types (--types) are announced over Cyclone DDS alone: Fast DDS crashes on some that its "
        "peers announce; use --dds cyclonedds");
  }
  if (network.dds == DdsVendor::kCycloneDds) {
    const auto is_loopback = [](const std::string& one) { return one.starts_with("127."); };
    const auto on_loopback = std::ranges::count_if(network.interfaces, is_loopback);
    if (on_loopback > 0 && on_loopback < std::ssize(network.interfaces)) {
      problems.emplace_back(
          "Cyclone DDS is deaf on other interfaces when it is on the loopback interface too: use "
          "one "
          "kind, or --dds fastdds");
    }
    if (!network.discovery_servers.empty()) {
      problems.emplace_back(
          "Cyclone DDS knows no discovery server: name peers, or use --dds fastdds");
    }
    if (!network.keys.empty()) {
      problems.emplace_back(
          "keys (--security) need Fast DDS in all nodes: they do not go with --dds cyclonedds");
    }
  }
  return problems;
}

}  // namespace skein::blackboard
