// SPDX-License-Identifier: Apache-2.0
// `skein spy`: what is on the wire.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "skein/blackboard/network.hpp"

namespace skein::spy_tool {

struct SpyOptions {
  std::uint32_t domain = 0;
  blackboard::NetworkConfig network;
  /// DDS partitions to listen in; `*` and `?` as DDS has them.
  std::vector<std::string> partitions{"world", "onboard/*", "radio/*"};
  std::vector<std::string> slots;  ///< by name; empty: all
  std::string from;                ///< only of this origin (name or number); empty: of all
  double duration = 0;             ///< [s] to listen; 0: 3 s for tables, for ever for samples
  std::uint64_t count = 0;         ///< samples to print; 0: no limit
  bool json = false;
};

/// Listens, then prints the nodes, and for each slot, origin and destination the number of samples,
/// their rate, and the age of the last one. Exit codes: 0, 2 wrong options, 3 no DDS, 4 nothing
/// heard.
int list(const SpyOptions& options, std::ostream& out, std::ostream& err);

/// Prints samples as they come, until `count`, `duration` or Ctrl-C. Same exit codes.
int echo(const SpyOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::spy_tool
