// SPDX-License-Identifier: Apache-2.0
// Laws of links that are cut and come back, and of events past relays.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/journal/record.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::laws {

struct HealingLimits {
  /// After both directions are up again, until both nodes know it and have what was waiting.
  Duration healing = Duration::seconds(3);
  /// Shorter cuts need not be noticed.
  Duration noticed = Duration::seconds(5);
  /// After the last change of any link, until ways past relays are as they will be and what was
  /// waiting has come.
  Duration rerouting = Duration::seconds(20);
};

/// By its radio, in virtual time: three heartbeats, the latency both ways, and where heartbeats are
/// lost by chance so many more that hardly ever all of them are.
HealingLimits healing_limits(const scenario::Scenario& scenario);

/// What holds of every link that was down in both directions or one, and of every event, whatever
/// else happened; by the log alone, where `link` lines are the truth. Breaches with their instants:
/// - healed: when both directions of a pair have come back and stay, then within `healing` both
///   nodes say that they reach the other, if they ever said that they do not;
/// - caught up: an event sent before or during the cut was received, or told to be expired or lost,
///   within `healing` of the return;
/// - none lost: at the log's end every event was received, or told to be expired or lost, but for
///   those between nodes of which one died or restarted, or whose link was down within `healing` of
///   the end; then past relays (nodes that `route` lines name, and that did not die) if there was a
///   way in both directions during the last `rerouting`.
/// Nothing is said where the simulator died, who tells the truth.
std::vector<std::string> broken_healing(const std::vector<journal::Record>& records,
                                        const HealingLimits& limits = {});

}  // namespace skein::laws
