// SPDX-License-Identifier: Apache-2.0
// Numbers of messages and requests.
#pragma once

#include <algorithm>
#include <cstdint>

#include "skein/foundation/time.hpp"

namespace skein::merging {

/// Numbers that go on rising in the life after one that is forgotten: none is below mission time.
struct Rising {
  std::uint64_t last = 0;

  /// [ms]; what is given from then on is no less.
  static std::uint64_t least(MissionTime now) {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(now.count(), 0)) / 1'000'000;
  }
  std::uint64_t next(MissionTime now) { return last = std::max(last + 1, least(now)); }
};

}  // namespace skein::merging
