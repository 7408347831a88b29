// SPDX-License-Identifier: Apache-2.0
// Which looks that found something go to the ground station as events.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "skein/foundation/time.hpp"

namespace skein::ddn {

/// Of each device twenty looks at once, then one each five seconds. An alarm rests on its first
/// looks; a fire that is watched for an hour is seen again by the next, and would fill a slow
/// channel.
class SightingBudget {
 public:
  static constexpr std::int64_t kAtOnce = 20;
  static constexpr Duration kEach = Duration::milliseconds(5'000);

  /// Whether this look may be an event; then it is counted. `now` must not go back.
  bool take(const std::string& device, MissionTime now);

 private:
  std::map<std::string, MissionTime> full_;  ///< when the device will have its whole budget again
};

}  // namespace skein::ddn
