// SPDX-License-Identifier: Apache-2.0
// What was planned, put beside what was done.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/report/journal.hpp"

namespace skein::report {

/// A task of a UAV: its name and the task's id.
using TaskKey = std::pair<std::string, std::uint64_t>;

/// One task that a plan ever held.
struct Promise {
  /// As the last revision had it before it started; as the last one had it, if it never did.
  const PlannedRecord* planned = nullptr;
  std::optional<double> started, over;  ///< [s]
  std::string outcome;                  ///< "ended", "aborted"; empty: none
  std::string reason;                   ///< of the abort
};

/// A high-level task and what became of it.
struct GoalStory {
  std::string uav;
  const GoalRecord* first = nullptr;                   ///< with statement and who asked
  std::vector<std::pair<double, std::string>> states;  ///< [s]; a state once in succession
  std::string why;                                     ///< the last reason given
};

/// Points into the journal it was told from.
struct Deliberation {
  std::map<TaskKey, Promise> promises;
  std::vector<GoalStory> goals;  ///< in the order first heard of
  const GoalStory* goal(const std::string& uav, std::uint64_t id) const;
};

/// Precondition: the journal is in time order.
Deliberation tell_deliberation(const Journal& journal);

}  // namespace skein::report
