// SPDX-License-Identifier: Apache-2.0
#include "skein/run_tool/whole_run.hpp"

#include <algorithm>
#include <sstream>

#include "play_virtual.hpp"
#include "run_folder.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/journal/lines/run.hpp"
#include "skein/laws/waiting.hpp"

namespace skein::run_tool {

namespace {

// The verdicts become the last records of the event log.
void append_verdicts(const std::vector<scenario::Verdict>& verdicts,
                     std::vector<journal::Record>& records) {
  const MissionTime at = records.empty() ? MissionTime() : records.back().at();
  for (const scenario::Verdict& verdict : verdicts) {
    records.push_back(journal::record_of(
        at, "runner",
        journal::lines::Expectation{
            .name = verdict.name, .passed = verdict.passed, .seen = verdict.seen}));
  }
}

}  // namespace

WholeRun judged(const scenario::Scenario& scenario, Played played, Duration allowed_late) {
  const bool stopped = played.end == Played::End::kTimeLimit || played.end == Played::End::kIdle;
  if (stopped && !played.records.empty()) {
    for (const journal::Record& line :
         laws::waiting_lines(laws::waits_of(scenario, played.records), played.records.back().at()))
      played.records.push_back(line);
  }
  auto verdicts = scenario::check(scenario.expectations, played.records, allowed_late);
  append_verdicts(verdicts, played.records);
  return {std::move(played), std::move(verdicts)};
}

WholeRun play_whole(const scenario::Scenario& scenario) {
  std::ostringstream nobody;
  Progress progress(nobody, Progress::Style::kNone, {});
  return judged(scenario, play_virtual(scenario, progress));
}

bool ended_unjudged(const WholeRun& run) {
  return run.verdicts.empty() &&
         (run.played.end == Played::End::kTimeLimit || run.played.end == Played::End::kIdle);
}

int exit_code_of(const WholeRun& run) {
  if (run.played.end == Played::End::kInterrupted) return kExitInterrupted;
  if (run.played.end == Played::End::kFailed)
    return run.played.timed_out ? kExitTimeout : kExitSystem;
  const bool met = std::all_of(run.verdicts.begin(), run.verdicts.end(),
                               [](const scenario::Verdict& verdict) { return verdict.passed; });
  return met && !ended_unjudged(run) ? kExitOk : kExitNegative;
}

Result<void, Failure> keep_run(const std::string& folder, const scenario::Scenario& scenario,
                               const std::string& text, const WholeRun& run) {
  const auto claimed = prepare_folder(folder);
  if (!claimed) return tl::unexpected(claimed.error());
  const auto written = write_folder(
      folder, scenario, run_info(scenario, true, 0, run.played.records), run.played.records, text);
  if (!written) return tl::unexpected(written.error());
  return {};
}

}  // namespace skein::run_tool
