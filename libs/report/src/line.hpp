// SPDX-License-Identifier: Apache-2.0
// A line of the event log of a kind that only one view knows.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "skein/report/journal.hpp"

namespace skein::report {

/// Keys that are absent, or of another kind, are as if empty.
struct Line {
  double t = 0.0;  ///< [s]
  nlohmann::json keys;

  std::string text(const char* key) const;
  double number(const char* key) const;
  std::optional<std::int64_t> whole(const char* key) const;
};

/// Nothing for a record without keys of its own.
std::optional<Line> line_of(const OtherRecord& record);

}  // namespace skein::report
