// SPDX-License-Identifier: Apache-2.0
// The folder that a run left, read again.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/journal/record.hpp"
#include "skein/report/run_info.hpp"

namespace skein::recording {

struct Run {
  std::string folder;
  report::RunInfo info;                  ///< run.json
  std::string events;                    ///< events.jsonl, as it is
  std::vector<journal::Record> records;  ///< its lines, in the order of time
  Diagnostics damaged;                   ///< lines that could not be read and are left out
  MissionTime until() const { return records.empty() ? MissionTime() : records.back().at(); }
};

/// The greatest file that is read [byte].
inline constexpr std::size_t kMostBytes = 1'000'000'000;

/// Every reason at once for which a folder is not that of a run: what is not there, too large, or
/// written otherwise. Lines of the event log that are damaged are no such reason as long as one can
/// be read. Cost: time and memory of the order of the files' size.
Result<Run, Diagnostics> read_run(const std::string& folder);

/// The lines of an event log, in the order of time; those that cannot be read are told to `damaged`
/// with their numbers.
std::vector<journal::Record> read_events(const std::string& text, const std::string& file,
                                         Diagnostics& damaged);

}  // namespace skein::recording
