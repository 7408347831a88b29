// SPDX-License-Identifier: Apache-2.0
// One run of a batch.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/scenario/scenario.hpp"
#include "sweep.hpp"

namespace skein::batch_tool {

/// A run to be played.
struct Case {
  std::string scenario;     ///< its name
  std::string file, text;   ///< file of the scenario; its text with the combination applied
  Combination combination;  ///< values of the sweeps
  std::uint64_t seed = 1;
  std::string folder;  ///< for the results of the run; empty: not kept
};

/// The result of a run.
struct Row {
  std::string scenario;
  Combination combination;
  std::uint64_t seed = 1;
  /// passed; failed (expectations); time-limit, idle (it did not end, and expects nothing); died,
  /// hung (the process); interrupted; unwritten (its folder).
  std::string outcome;
  std::string reason;   ///< empty of one that passed
  double duration = 0;  ///< [s] of mission time until the run ended
  int goals = 0, achieved = 0, failed = 0;
  std::vector<std::pair<std::string, bool>> expectations;
  std::vector<std::pair<std::string, std::optional<double>>> measures;  ///< absent: not measurable
  std::vector<std::string> laws;    ///< names of violated laws, each once
  std::vector<std::string> breaks;  ///< the first violation of each of them, as a sentence

  bool good() const { return outcome == "passed" && laws.empty(); }
};

/// Plays a case in this process. Precondition: its text was read without errors, with these
/// degrees.
Row play_case(const Case& what, const std::vector<std::string>& degrees);

/// Reads, changes and checks the scenario of a case; every error at once, after the combination.
Result<scenario::Scenario, Diagnostics> scenario_of(const Case& what,
                                                    const std::vector<std::string>& degrees);

/// One line of JSON, and back: what a process tells of its run. Nothing for what is no row.
std::string to_json(const Row& row);
std::optional<Row> row_from_json(const std::string& text);

}  // namespace skein::batch_tool
