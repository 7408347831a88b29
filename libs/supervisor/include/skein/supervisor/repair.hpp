// SPDX-License-Identifier: Apache-2.0
// Operator 6: repairs a plan after a failure or an unforeseen event.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "skein/supervisor/insertion.hpp"

namespace skein::supervisor {

/// Steps of repair, the mildest first. Source: spec 6.2 (6).
enum class RepairStep : std::uint8_t {
  kAbsorb,  ///< the plan's network is still controllable and keeps the promised dates
  kShift,   ///< it is still controllable, with other dates
  kRefine,  ///< the failed high-level task is refined again from here; the others stay
  kDrop,    ///< the high-level task fails, and those that depend on it
  kReplan,  ///< all remaining tasks are planned anew in the best order; infeasible ones fail
  kReturn,  ///< all high-level tasks fail; the UAV lands, at home if its energy lasts so far, else
            ///< at the nearest suitable place
  kFail     ///< nothing can be planned: the mission has failed, safe mode
};
/// "absorb", "shift", "re-refine", "drop", "replan", "return and land", "fail".
std::string_view to_text(RepairStep step);

struct RepairRequest {
  PlanningRequest base;  ///< `tasks` is ignored; `situation` is the state after `standing`
  Standing standing;     ///< the tasks that the executive keeps
  std::optional<mission::HighLevelTask> failed;  ///< its progress is in base.situation.done
  bool refine_failed = true;                     ///< false: kRefine is skipped, it was tried enough
  /// `failed` goes behind all of `remaining`, if that is feasible: the cause of its failure may be
  /// over by then.
  bool failed_goes_behind = false;
  std::vector<mission::HighLevelTask> remaining;  ///< in the order of the plan, without `failed`
  std::size_t failed_at = 0;                      ///< position of `failed` among them
  /// Of `remaining`, those of the mission of `failed`: what is done in place there depends on it.
  std::set<mission::GoalId> given_with_failed;
  /// The landing for kReturn. Absent: the domain has no such task, or the UAV is on the ground.
  std::optional<mission::HighLevelTask> retreat;
};

struct RepairOutcome {
  RepairStep served = RepairStep::kFail;
  std::optional<mission::ElementaryPlan> plan;  ///< absent: kFail
  std::vector<mission::HighLevelTask> order;
  std::vector<Dropped> dropped;
  Schedule schedule;  ///< of `standing` and the plan together
  std::vector<Shortened> shortened;
  std::vector<std::string> before;  ///< for each milder step that was tried, why it failed
};

/// Tries the steps that need planning, in order: kRefine, kDrop, kReplan, kReturn; the first that
/// succeeds is the outcome, else kFail. A plan succeeds if it is dynamically controllable and its
/// energy, including the way home from its end, is not more than what is left above the reserve; a
/// landing alone always succeeds: at home if the energy lasts so far, else on the nearest suitable
/// ground. kReplan leaves out tasks one by one, those that end a flight last. Each step shortens
/// durations given as ranges before it is given up. A job. Source: T IV.4.2 (SCD-6).
RepairOutcome repair_plan(const RepairRequest& request);

}  // namespace skein::supervisor
