// SPDX-License-Identifier: Apache-2.0
// Plays a scenario to its end in virtual time and checks its expectations: `skein run --virtual`
// without its output.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/run_tool/played.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::run_tool {

struct WholeRun {
  Played played;  ///< with the verdicts as its last records
  std::vector<scenario::Verdict> verdicts;
};

/// Adds the verdicts to what was played; `allowed_late` is that of scenario::check.
WholeRun judged(const scenario::Scenario& scenario, Played played,
                Duration allowed_late = Duration());

/// Of a scenario whose overrides are applied. Ctrl-C ends it early.
WholeRun play_whole(const scenario::Scenario& scenario);

/// That of `skein run`; kExitOk: everything is as expected.
int exit_code_of(const WholeRun& run);

/// Whether the run did not reach the end of its mission, and the scenario has no expectations.
bool ended_unjudged(const WholeRun& run);

/// Writes the same folder as `skein run --virtual`; `text` is that of the scenario.
Result<void, Failure> keep_run(const std::string& folder, const scenario::Scenario& scenario,
                               const std::string& text, const WholeRun& run);

}  // namespace skein::run_tool
