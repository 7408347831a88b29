// SPDX-License-Identifier: Apache-2.0
// Rate limit for detections that are sent to the ground station as events.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "skein/foundation/time.hpp"

namespace skein::ddn {

/// Token bucket per device: twenty perceptions at once, then one every five seconds. An alarm
/// depends on the first perceptions; a fire watched for an hour is perceived again and again, and
/// would fill a slow channel.
class SightingBudget {
 public:
  static constexpr std::int64_t kAtOnce = 20;
  static constexpr Duration kEach = Duration::milliseconds(5'000);

  /// Whether this perception may be an event; if so it is counted. `now` must not decrease.
  bool take(const std::string& device, MissionTime now);

 private:
  std::map<std::string, MissionTime> full_;  ///< when the device will have its whole budget again
};

}  // namespace skein::ddn
