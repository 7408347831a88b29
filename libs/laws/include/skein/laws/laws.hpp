// SPDX-License-Identifier: Apache-2.0
// Laws that every run must keep, judged by the log's truth and the scenario, never by a plan.
#pragma once

#include <string>
#include <vector>

#include "skein/laws/history.hpp"
#include "skein/laws/violation.hpp"

namespace skein::laws {

/// A law: its name, its statement in one sentence, and a function that finds violations.
struct Law {
  std::string name;
  std::string says;
  std::vector<Violation> (*broken)(const History&);
};

/// All laws, in the order of the documentation (README).
const std::vector<Law>& all_laws();

/// Every violation of every law (or of `only`), in the order of time. `late`: History::late.
std::vector<Violation> broken_laws(const scenario::Scenario& scenario,
                                   const std::vector<journal::Record>& records,
                                   const std::vector<std::string>& only = {},
                                   Duration late = Duration());

/// Instants at which UAVs in the air were nearer to each other than their models permit, in the
/// order of time. Like law `separation`, but also for scenarios that do not ask for separation.
std::vector<Violation> too_near(const scenario::Scenario& scenario,
                                const std::vector<journal::Record>& records);

/// High-level tasks that UAVs were given, and what became of them.
struct GoalCount {
  int all = 0, achieved = 0, failed = 0;
};
GoalCount count_goals(const History& history);

/// The least distance [m] between two UAVs while both fly; nothing when they never do.
struct Nearest {
  double distance = kNever;
  double at = 0;
  std::string first, second;
};
std::optional<Nearest> nearest(const History& history);

}  // namespace skein::laws
