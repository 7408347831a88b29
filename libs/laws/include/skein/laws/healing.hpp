// SPDX-License-Identifier: Apache-2.0
// Laws of links that are cut and come back.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/journal/record.hpp"

namespace skein::laws {

struct HealingLimits {
  /// After both directions are up again, until both nodes know it and have what was waiting.
  Duration healing = Duration::seconds(3);
  /// Shorter cuts need not be noticed.
  Duration noticed = Duration::seconds(5);
};

/// What holds of every link that was down in both directions or one, and of every event, whatever
/// else happened; by the log alone, where `link` lines are the truth. Breaches with their instants:
/// - healed: when both directions of a pair have come back and stay, then within `healing` both
///   nodes say that they reach the other, if they ever said that they do not;
/// - caught up: an event sent before or during the cut was received, or told to be expired or lost,
///   within `healing` of the return;
/// - none lost: at the log's end every event was received, or told to be expired or lost, but for
///   those between nodes of which one died or restarted, or whose link was down within `healing` of
///   the end.
std::vector<std::string> broken_healing(const std::vector<journal::Record>& records,
                                        const HealingLimits& limits = {});

}  // namespace skein::laws
