// SPDX-License-Identifier: Apache-2.0
// Laws on radio links that are cut and restored, and on events that pass relays.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/journal/record.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::laws {

struct HealingLimits {
  /// Time after both directions are up again until both nodes know it and have received waiting
  /// events.
  Duration healing = Duration::seconds(3);
  /// More for each event that waits before another one: on a narrow channel they come one by one.
  Duration each;
  /// Cuts shorter than this need not be noticed: three heartbeats and two seconds.
  Duration noticed = Duration::seconds(5);
  /// Time after the last change of any link until routes past relays are final and waiting events
  /// have been received; also those that wait past a relay when the link is whole again.
  Duration rerouting = Duration::seconds(20);
  /// More where one direction alone was cut and heartbeats are further apart than `healing`: who
  /// was not heard hears the other all along, and nothing but its next one tells that the link is
  /// back.
  Duration next_heartbeat = {};
};

/// Limits for the scenario's radio, in virtual time: a second and the latency both ways. Where
/// nodes are not told that a link is up (`silent`), where it is narrow (`capacity`) or loses
/// samples at random, three heartbeats instead of the second, and with losses so many more that the
/// loss of all is very unlikely. `each`: 600 bytes on the narrowest channel.
HealingLimits healing_limits(const scenario::Scenario& scenario);

/// Breaches, with their instants, of the laws on links that were down in one or both directions,
/// and on events; by the log alone, whose `link` lines are the truth:
/// - healed: when both directions of a pair have come back and stay, then within `healing` (and
///   `next_heartbeat`) both nodes say that they reach the other, if they ever said that they do
///   not;
/// - caught up: an event sent before or during the cut was received, or told to be expired or lost,
///   within `healing` of the return (`rerouting` where it goes past a relay then), and `each` for
///   each one that waited before it;
/// - none lost: at the log's end every event was received, or told to be expired or lost, but for
///   those between nodes of which one died or restarted, or whose link was down within `healing` of
///   the end; then past relays (nodes that `route` lines name, and that did not die) if there was a
///   way in both directions during the last `rerouting`.
/// No breaches are reported if the simulator died, since it writes the `link` lines.
std::vector<std::string> broken_healing(const std::vector<journal::Record>& records,
                                        const HealingLimits& limits = {});

}  // namespace skein::laws
