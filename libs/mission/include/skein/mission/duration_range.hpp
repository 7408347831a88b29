// SPDX-License-Identifier: Apache-2.0
// Durations that may be shorter when time or energy is short.
#pragma once

#include <optional>
#include <string_view>

#include "skein/mission/high_level_task.hpp"

namespace skein::mission {

/// "60..120": 120 s where there is room for them, 60 at least [s]. As an argument of a high-level
/// task it stands in the place of a duration.
struct DurationRange {
  double least = 0, most = 0;
  bool operator==(const DurationRange&) const = default;
};

/// Absent: it is not written so. The figures may be any from 0: least above most, too.
std::optional<DurationRange> duration_range_from(std::string_view text);
std::optional<DurationRange> duration_range_of(const Argument& argument);

}  // namespace skein::mission
