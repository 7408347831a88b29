// SPDX-License-Identifier: Apache-2.0
// Records as log messages for people.
#pragma once

#include <optional>
#include <string>

#include "skein/journal/record.hpp"

namespace skein::journal {

/// Log levels, with the numbers of foxglove.LogLevel.
enum class Level { kDebug = 1, kInfo = 2, kWarning = 3, kError = 4 };

struct LogLine {
  Level level = Level::kInfo;
  std::string text;
};

/// Of a record that is worth a line: decisions, refusals, degrees, goals, alarms, phases, faults,
/// verdicts, notices, who got which task of the team.
std::optional<LogLine> log_line_of(const Record& record);

}  // namespace skein::journal
