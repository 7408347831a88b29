// SPDX-License-Identifier: Apache-2.0
// One node of a team that only meets.
#pragma once

#include <cstdint>
#include <string>

#include "skein/foundation/time.hpp"

namespace skein::node::bench {

struct ScaleOptions {
  int nodes = 4;  ///< decision nodes, beside the ground station
  /// How long a node is watched once all have met, and how long they may take for that [s].
  double idle = 10, limit = 120;
  int stagger = 0;  ///< between two starts [ms]
  std::string server, dds;
  bool least = false;    ///< one writer and one reader each, which all connect: the vendor's share
  bool types = false;    ///< announced, over Cyclone DDS
  bool at_once = false;  ///< all endpoints are made at the beginning
};

/// What one node found out.
struct Found {
  double matched = -1;   ///< [s] since the first start; -1: not within the limit
  double opened = 0;     ///< [s] that opening the transport took
  double processor = 0;  ///< [s] until it was matched
  double idle = 0;       ///< share of a processor afterwards
  double memory = 0;     ///< private [MB]
};

/// A node until it is told to end: writes the first three to standard output, waits for a line of
/// standard input, measures and writes the others, and waits for another.
int play_node(const ScaleOptions& options, std::uint32_t domain, const std::string& name,
              Duration begun);

}  // namespace skein::node::bench
