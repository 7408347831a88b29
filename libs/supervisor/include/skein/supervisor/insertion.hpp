// SPDX-License-Identifier: Apache-2.0
// Operator 1: where new high-level tasks go among those already planned.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/mission/duration_range.hpp"
#include "skein/supervisor/planning.hpp"
#include "skein/supervisor/schedule.hpp"

namespace skein::supervisor {

/// What the executive has in hand and keeps; new tasks come after it.
struct Standing {
  std::vector<mission::ElementaryTask> tasks;
  Observations seen;
  GoalBounds bounds = {};  ///< of all high-level tasks, those to be planned too
};

/// A high-level task that is not part of a plan.
struct Dropped {
  mission::GoalId goal;
  std::string why;
};

/// A high-level task that is given less than the longest duration it was asked for with.
struct Shortened {
  mission::GoalId goal;
  mission::DurationRange asked;
  Duration given;
};
/// "goal 701 to 84 s of 60 to 120"; several with commas.
std::string to_text(const std::vector<Shortened>& all);
/// What they lack of their longest durations together.
Duration total_of(const std::vector<Shortened>& all);

/// A bound from above that would have to be another one.
struct Relaxation {
  mission::GoalId goal;
  std::string bound;       ///< "start-before", "end-before", "start-after-goal 701 at most"
  Duration asked, needed;  ///< in mission time; after a goal, from its end
};
/// "goal 701 end-before 752 s instead of 558 s".
std::string to_text(const Relaxation& one);

struct InsertionRequest {
  PlanningRequest base;  ///< its tasks do not count; the situation is that after `standing`
  Standing standing;
  std::vector<mission::HighLevelTask> planned;  ///< free to move, in the order of the plan
  std::vector<mission::HighLevelTask> added;    ///< in the order wanted
  mission::Placement placement = mission::Placement::kBest;
  bool any = false;  ///< what of `added` cannot be planned is left out
  /// The number that a part of a mapping would have; absent: none is flown in parts.
  std::optional<mission::GoalId> part = {};
};

/// One order that was tried.
struct Trial {
  mission::Placement placement = mission::Placement::kLast;
  std::vector<mission::GoalId> order;
  double part = 0;  ///< share of a mapping's lanes that is flown before something else; 0: none is
  bool feasible = false;
  double cost = 0;                         ///< of the plan, where there is one
  Duration shortened;                      ///< what it takes from durations that may be shorter
  std::vector<std::string> reasons;        ///< why it is not feasible
  std::optional<mission::GoalId> culprit;  ///< the task that this is because of, where it is one
};

struct InsertionOutcome {
  /// Of the best feasible order: all that was planned and added. Absent: there is none.
  std::optional<mission::ElementaryPlan> plan;
  std::vector<mission::HighLevelTask> order;
  mission::Placement chosen = mission::Placement::kLast;
  Schedule schedule;  ///< of `standing` and the plan together
  std::vector<Shortened> shortened;
  /// Without a plan: bounds with which there would be one, of all that was asked for. Empty: no
  /// bounds help, or none were looked for.
  std::vector<Relaxation> relaxations;
  /// Of `added`, what the plan has not; without a plan, the tasks because of which there is none.
  std::vector<Dropped> dropped;
  std::vector<Trial> trials;
  std::vector<std::string> reasons;  ///< why there is no plan: of every trial, each once
};

/// Tries the placements that the request allows (spec 6.2 (1)): (a) after all, (b) by temporal
/// compatibility with absolute constraints, (c) by spatial compatibility, through a tour over the
/// places of what is free to move; plans each and keeps the one of least cost that is dynamically
/// controllable, of equals the first. Takeoffs stay first, landings and waits for orders last.
/// kFirst: added before planned. Tasks without a place stay behind their predecessor; those that
/// synchronise keep their order. With nothing planned the mission is planned in the order asked
/// for, unless kTour is. A plan must also leave the energy reserve alone. What an order lacks in
/// time or energy is taken from durations that are given as ranges, the same part of each; the
/// order that takes least is kept before one of less cost. What kBest or kInTime find no place for
/// otherwise because of absolute bounds may have it between two parts of a mapping that has not
/// begun: shares of its lanes are tried by halving, to eighths, more before as long as that serves;
/// the part is in the order as a task of its own (kMapPart). A job. Source: T IV.4.2 (SCD-1).
InsertionOutcome insert_tasks(const InsertionRequest& request);

}  // namespace skein::supervisor
