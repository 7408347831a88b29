// SPDX-License-Identifier: Apache-2.0
// The course of deliberation: planned tasks with their execution, high-level tasks with their
// states.
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

/// A task of any plan revision, as planned and as executed.
struct Promise {
  /// The task in the last revision before its start; if it never started, in the last revision that
  /// contains it.
  const PlannedRecord* planned = nullptr;
  std::optional<double> started, over;  ///< [s]
  std::string outcome;                  ///< "ended", "aborted"; empty: none
  std::string reason;                   ///< of the abort
};

/// A high-level task with its states over time.
struct GoalStory {
  std::string uav;
  const GoalRecord* first = nullptr;                   ///< has the statement and the requester
  std::vector<std::pair<double, std::string>> states;  ///< [s]; repetitions left out
  std::string why;                                     ///< the last reason given
};

/// Holds pointers into the journal that it was made from.
struct Deliberation {
  std::map<TaskKey, Promise> promises;
  std::vector<GoalStory> goals;  ///< in the order first heard of
  const GoalStory* goal(const std::string& uav, std::uint64_t id) const;
};

/// Precondition: the journal is in time order.
Deliberation tell_deliberation(const Journal& journal);

}  // namespace skein::report
