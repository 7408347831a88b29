// SPDX-License-Identifier: Apache-2.0
// The drawing of a log that is written in a test.
#pragma once

#include <string>

#include "builders.hpp"
#include "timeline/timeline.hpp"

namespace skein::report::testing {

/// One UAV in the air for 90 s.
inline constexpr const char* kFlight =
    R"({"at":0,"node":"sim","kind":"telemetry","uav":"uav1","position":[0,0,40],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
{"at":90,"node":"sim","kind":"telemetry","uav":"uav1","position":[0,0,40],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
)";

inline std::string page_of_timeline(const std::string& log) {
  const SalvagedJournal read = salvage(log);
  const Chronology story = tell({}, read.journal);
  const Statistics figures = measure(story, read.journal);
  const Deliberation plans = tell_deliberation(read.journal);
  const RunInfo info{};
  Markup out;
  write_timeline(out, Run{info, read.journal, story, figures, plans});
  return out.take();
}

}  // namespace skein::report::testing
