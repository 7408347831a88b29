// SPDX-License-Identifier: Apache-2.0
// Nodes that talk all the time over a bad radio, as a load for the virtual runtime.
#pragma once

#include <string>
#include <vector>

#include "skein/node/virtual_runtime.hpp"

namespace skein::node::testing {

struct Cut {
  std::string a, b;
  MissionTime from, until;
};

/// What one run came to.
struct Played {
  VirtualOutcome outcome;
  std::string log;        ///< every record, one line each
  std::string violation;  ///< of the law of events: received once per life, in the order sent
};

/// ground, sim and `uavs` nodes; each sends events and streams to peers of its random choice. The
/// simulator makes all links slow and lossy, cuts them and restores them.
struct PingSystem {
  std::uint64_t seed = 1;
  int uavs = 2;
  std::vector<Crash> crashes;
  std::vector<Cut> cuts;
  MissionTime time_limit = MissionTime::seconds(20);
  double loss = 0.3;    ///< of streams, on every link
  bool silent = false;  ///< the radio cuts by itself: no node is told

  static PingSystem random(std::uint64_t seed);
  Played play() const;
};

}  // namespace skein::node::testing
