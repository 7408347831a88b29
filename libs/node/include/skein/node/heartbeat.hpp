// SPDX-License-Identifier: Apache-2.0
// The period of heartbeats.
#pragma once

#include <algorithm>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/time.hpp"

namespace skein::node {

/// Shortest period of heartbeats in steady time, whatever the rate. A busy machine may stand still
/// for three periods before its peers consider it unreachable.
inline constexpr Duration kLeastSteadyHeartbeat = Duration::milliseconds(100);

/// Converts the period `heartbeat` of mission time to steady time, at `rate` mission seconds per
/// steady second; at least kLeastSteadyHeartbeat, so that at high rates the period in mission time
/// grows with the rate. Precondition: both > 0.
inline Duration steady_heartbeat(Duration heartbeat, double rate) {
  SKEIN_EXPECTS(heartbeat > Duration{} && rate > 0);
  return std::max(Duration::seconds(heartbeat.to_seconds() / rate), kLeastSteadyHeartbeat);
}

}  // namespace skein::node
