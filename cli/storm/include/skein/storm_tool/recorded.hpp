// SPDX-License-Identifier: Apache-2.0
// Runs that were played before, judged by the laws: `skein judge`.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/laws/judgement.hpp"
#include "skein/recording/run.hpp"
#include "skein/scenario/scenario.hpp"
#include "skein/storm_tool/judge.hpp"

namespace skein::storm_tool {

/// The folder of a run, with the scenario as it was played.
struct Recorded {
  scenario::Scenario scenario;
  recording::Run run;
};

/// The scenario is `scenario.yaml` of the folder, with the seed, the rate and the degrees of
/// run.json. Every error at once.
Result<Recorded, Diagnostics> read_recorded(const std::string& folder);

/// [s] On a machine that does other things as well.
inline constexpr double kLateOnTheWall = 0.5;

/// What the log of a scenario came to. `judging`: by which laws.
Verdict verdict_on(const scenario::Scenario& scenario, const std::vector<journal::Record>& records,
                   const laws::Judging& judging);
/// `only`: names of laws; all if empty. `late`: [s] of the clock on the wall by which what passes
/// between nodes may be late in a run over DDS; not used for runs in virtual time.
Verdict verdict_on(const Recorded& recorded, const std::vector<std::string>& only,
                   double late = kLateOnTheWall);

struct JudgeRunsOptions {
  std::vector<std::string> folders;  ///< of runs
  std::vector<std::string> only;     ///< names of laws; all if empty
  double late = kLateOnTheWall;      ///< [s]
  bool list_laws = false;
  bool json = false;  ///< one document
};

/// Judges each and tells what it came to. Exit codes: 0 no law was broken, 1 some, 2 a folder
/// cannot be read or a law is not known.
int judge_runs(const JudgeRunsOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::storm_tool
