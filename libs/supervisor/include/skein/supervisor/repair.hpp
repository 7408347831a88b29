// SPDX-License-Identifier: Apache-2.0
// Operator 6: what is left of a plan after something happened to it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/supervisor/insertion.hpp"

namespace skein::supervisor {

/// From the mildest on. Source: spec 6.2 (6).
enum class RepairStep : std::uint8_t {
  kAbsorb,  ///< the network still holds with the dates that were promised
  kShift,   ///< it holds with other dates
  kRefine,  ///< the failed high-level task is refined again from here; the others stay
  kDrop,    ///< it fails, and what depends on it
  kReplan,  ///< all that remains is planned anew, in the best order, without what cannot be
  kReturn,  ///< all of it fails; the UAV flies to the nearest place to land, home if it can, and
            ///< lands
  kFail     ///< nothing can be planned: the mission has failed, safe mode
};
/// "absorb", "shift", "re-refine", "drop", "replan", "return and land", "fail".
std::string_view to_text(RepairStep step);

struct RepairRequest {
  PlanningRequest base;  ///< its tasks do not count; the situation is that after `standing`
  Standing standing;     ///< what the executive keeps
  std::optional<mission::HighLevelTask> failed;  ///< what is left to do of it is all of it
  bool refine_failed = true;                     ///< false: it was refined often enough
  /// Refined behind all that is free, if it can be: what it failed for may be over by then.
  bool failed_goes_behind = false;
  std::vector<mission::HighLevelTask> remaining;  ///< in the order of the plan, without `failed`
  std::size_t failed_at = 0;                      ///< position of `failed` among them
  /// A landing, for when nothing else serves. Absent: there is no such task, or it is on the
  /// ground.
  std::optional<mission::HighLevelTask> retreat;
};

struct RepairOutcome {
  RepairStep served = RepairStep::kFail;
  std::optional<mission::ElementaryPlan> plan;  ///< absent: kFail
  std::vector<mission::HighLevelTask> order;
  std::vector<Dropped> dropped;
  Schedule schedule;  ///< of `standing` and the plan together
  std::vector<Shortened> shortened;
  std::vector<std::string> before;  ///< of each milder step that was tried: why it did not serve
};

/// The steps that need planning, in order: kRefine, kDrop, kReplan, kReturn, kFail. A plan serves
/// when it is dynamically controllable and needs no more energy, the way home from its end with it,
/// than is left above the reserve; a landing alone serves always, at home when the energy lasts so
/// far, else where ground that serves is nearest. In kReplan the tasks that stand in the way are
/// left out one by one, those that end a flight last. In each step durations that are given as
/// ranges are shortened before it is said not to serve. A job. Source: T IV.4.2 (SCD-6).
RepairOutcome repair_plan(const RepairRequest& request);

}  // namespace skein::supervisor
