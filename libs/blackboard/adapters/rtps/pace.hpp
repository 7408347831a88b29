// SPDX-License-Identifier: Apache-2.0
// How often the protocol itself speaks, beside the samples.
#pragma once

#include <chrono>

#include "skein/blackboard/transport.hpp"

namespace skein::blackboard::rtps {

/// Periods of what RTPS says by itself: announcements of a participant, and the heartbeats of
/// reliable writers, each of which is answered. On a narrow channel they would leave no room for
/// anything else, and what is lost for want of room makes them come again.
struct Pace {
  std::chrono::milliseconds announcement{1000};
  std::chrono::milliseconds lease{5000};  ///< of a silent participant
  std::chrono::milliseconds heartbeat{50};
};

/// For a channel of so many bits a second; 0: unlimited. Announcements take at most a twentieth of
/// it, the heartbeats of one writer a fiftieth.
Pace pace_of(double capacity);
/// For all channels of a node: that of the narrowest.
Pace pace_of(const TransportPlan& plan);

}  // namespace skein::blackboard::rtps
