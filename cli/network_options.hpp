// SPDX-License-Identifier: Apache-2.0
// The options of commands that take part in a DDS domain.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "skein/blackboard/network.hpp"

namespace skein::cli {

/// The words of --dds. `skein` itself is linked without the blackboard, so they are not asked for
/// there.
inline const std::map<std::string, blackboard::DdsVendor> kDdsWords{
    {"fastdds", blackboard::DdsVendor::kFastDds},
    {"cyclonedds", blackboard::DdsVendor::kCycloneDds}};

inline void add_network(CLI::App* command, blackboard::NetworkConfig& network) {
  const auto choose = [&network](const std::string& name) { network.dds = kDdsWords.at(name); };
  command->add_option_function<std::string>("--dds", choose, "Whose DDS to use (default: fastdds)")
      ->check(CLI::IsMember(kDdsWords))
      ->type_name("WORD");
  command->add_option("--interface", network.interfaces, "IPv4 address to talk on")->delimiter(',');
  command->add_option("--peer", network.peers, "Where to look for others: ADDRESS or ADDRESS:PORT")
      ->delimiter(',');
  command->add_option("--multicast", network.multicast, "Look for others by multicast: on or off");
  command->add_option("--discovery-server", network.discovery_servers, "ADDRESS:PORT")
      ->delimiter(',');
  command->add_option("--security", network.keys, "Folder with the keys to take part with");
  for (const char* name : {"--interface", "--peer", "--discovery-server"}) {
    command->get_option(name)->allow_extra_args(false);
  }
}

}  // namespace skein::cli
