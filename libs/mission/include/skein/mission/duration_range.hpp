// SPDX-License-Identifier: Apache-2.0
// Durations that the planner may shorten if time or energy is short.
#pragma once

#include <optional>
#include <string_view>

#include "skein/mission/high_level_task.hpp"

namespace skein::mission {

/// "60..120": preferably 120 s, at least 60 s [s]. May be given as argument of a high-level task in
/// place of a duration.
struct DurationRange {
  double least = 0, most = 0;
  bool operator==(const DurationRange&) const = default;
};

/// Absent: the text is not of this form. The figures are >= 0 and not otherwise checked: `least`
/// may exceed `most`.
std::optional<DurationRange> duration_range_from(std::string_view text);
std::optional<DurationRange> duration_range_of(const Argument& argument);

}  // namespace skein::mission
