// SPDX-License-Identifier: Apache-2.0
// How often nodes say that they are there.
#pragma once

#include <algorithm>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/time.hpp"

namespace skein::node {

/// No heartbeat comes more often than this on the wall clock, whatever the rate: three of them are
/// what a busy machine may stand still without its peers taking it for gone.
inline constexpr Duration kLeastSteadyHeartbeat = Duration::milliseconds(100);

/// The steady period of heartbeats that a scenario wants every `heartbeat` of mission time, at
/// `rate` mission seconds per steady second. From the rate on at which that would be less than
/// kLeastSteadyHeartbeat it is that, and the mission's period grows with the rate. Both > 0.
inline Duration steady_heartbeat(Duration heartbeat, double rate) {
  SKEIN_EXPECTS(heartbeat > Duration{} && rate > 0);
  return std::max(Duration::seconds(heartbeat.to_seconds() / rate), kLeastSteadyHeartbeat);
}

}  // namespace skein::node
