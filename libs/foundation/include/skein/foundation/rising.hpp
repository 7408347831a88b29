// SPDX-License-Identifier: Apache-2.0
// Increasing numbers of messages, requests and tasks.
#pragma once

#include <algorithm>
#include <cstdint>

#include "skein/foundation/time.hpp"

namespace skein {

/// Numbers that increase also over a restart without memory: none is below mission time [ms].
struct Rising {
  std::uint64_t last = 0;

  /// The least number given at `now` or later [ms].
  static std::uint64_t least(MissionTime now) {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(now.count(), 0)) / 1'000'000;
  }
  std::uint64_t next(MissionTime now) { return last = std::max(last + 1, least(now)); }
};

}  // namespace skein
