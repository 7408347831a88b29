// SPDX-License-Identifier: Apache-2.0
#include "security.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

namespace skein::blackboard::fastdds {
namespace {

namespace fs = std::filesystem;
using eprosima::fastrtps::rtps::GuidPrefix_t;
using eprosima::fastrtps::rtps::PropertyPolicy;

struct Plugin {
  const char* property;
  const char* value;
};
constexpr std::array kPlugins = {Plugin{"dds.sec.auth.plugin", "builtin.PKI-DH"},
                                 Plugin{"dds.sec.access.plugin", "builtin.Access-Permissions"},
                                 Plugin{"dds.sec.crypto.plugin", "builtin.AES-GCM-GMAC"}};

struct KeyFile {
  const char* property;
  const char* name;
};
constexpr std::array kFiles = {
    KeyFile{"dds.sec.auth.builtin.PKI-DH.identity_ca", "ca.pem"},
    KeyFile{"dds.sec.auth.builtin.PKI-DH.identity_certificate", "cert.pem"},
    KeyFile{"dds.sec.auth.builtin.PKI-DH.private_key", "key.pem"},
    KeyFile{"dds.sec.access.builtin.Access-Permissions.permissions_ca", "ca.pem"},
    KeyFile{"dds.sec.access.builtin.Access-Permissions.governance", "governance.p7s"},
    KeyFile{"dds.sec.access.builtin.Access-Permissions.permissions", "permissions.p7s"}};

std::optional<std::uint8_t> byte_of(const std::string& digits) {
  if (digits.size() != 2 || digits.find_first_not_of("0123456789abcdef") != std::string::npos) {
    return std::nullopt;
  }
  return static_cast<std::uint8_t>(std::strtoul(digits.c_str(), nullptr, 16));
}

}  // namespace

Result<PropertyPolicy, Failure> security_properties(const std::string& folder) {
  PropertyPolicy policy;
  std::string missing;
  for (const Plugin& plugin : kPlugins) {
    policy.properties().emplace_back(plugin.property, plugin.value);
  }
  for (const KeyFile& file : kFiles) {
    const fs::path path = fs::path(folder) / file.name;
    const bool there = std::ifstream(path).good();
    if (!there && missing.find(file.name) == std::string::npos) {
      missing += (missing.empty() ? "" : ", ") + std::string(file.name);
    }
    policy.properties().emplace_back(file.property, "file://" + fs::absolute(path).string());
  }
  if (!missing.empty()) return failure("cannot read the keys in " + folder + ": " + missing);
  return policy;
}

Result<Identities, Failure> Identities::read(const std::string& folder) {
  const fs::path path = fs::path(folder) / "nodes";
  std::ifstream in(path);
  if (!in) return failure("cannot read " + path.string());
  Identities all;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream words(line);
    std::string name;
    std::string digits;
    words >> name >> digits;
    if (name.empty()) continue;
    Mark mark{};
    bool good = digits.size() == 2 * mark.size();
    for (std::size_t i = 0; good && i < mark.size(); ++i) {
      const auto byte = byte_of(digits.substr(2 * i, 2));
      good = byte.has_value();
      mark[i] = byte.value_or(0);
    }
    if (!good) {
      return failure(path.string() + ":" + std::to_string(number) +
                     ": expected a node and twelve hexadecimal digits");
    }
    all.marks_.insert_or_assign(std::move(name), mark);
  }
  return all;
}

bool Identities::confirm(const std::string& name, const GuidPrefix_t& guid) const {
  const auto found = marks_.find(name);
  return found != marks_.end() &&
         std::equal(found->second.begin(), found->second.end(), std::begin(guid.value));
}

}  // namespace skein::blackboard::fastdds
