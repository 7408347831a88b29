// SPDX-License-Identifier: Apache-2.0
// Operator 1: inserts new high-level tasks among those already planned.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/mission/duration_range.hpp"
#include "skein/supervisor/planning.hpp"
#include "skein/supervisor/schedule.hpp"

namespace skein::supervisor {

/// The tasks that the executive has and keeps; new tasks come after them.
struct Standing {
  std::vector<mission::ElementaryTask> tasks;
  Observations seen;
  GoalBounds bounds = {};  ///< of all high-level tasks, including those to be planned
};

/// A high-level task that the plan leaves out, or that prevents a plan.
struct Dropped {
  mission::GoalId goal;
  std::string why;
};

/// A high-level task whose duration was given as a range, and is planned shorter than its maximum.
struct Shortened {
  mission::GoalId goal;
  mission::DurationRange asked;
  Duration given;
};
/// "goal 701 to 84 s of 60 to 120"; several are separated by commas.
std::string to_text(const std::vector<Shortened>& all);
/// Sum of what the durations fall short of their maxima.
Duration total_of(const std::vector<Shortened>& all);

/// An upper bound on time that cannot be kept, and the value that could be.
struct Relaxation {
  mission::GoalId goal;
  std::string bound;       ///< "start-before", "end-before", "start-after-goal 701 at most"
  Duration asked, needed;  ///< since mission time zero; of a bound after a goal, since its end
};
/// "goal 701 end-before 752 s instead of 558 s".
std::string to_text(const Relaxation& one);

struct InsertionRequest {
  PlanningRequest base;  ///< `tasks` is ignored; `situation` is the state after `standing`
  Standing standing;
  std::vector<mission::HighLevelTask> planned;  ///< may be reordered; in the order of the plan
  std::vector<mission::HighLevelTask> added;    ///< in the order wanted
  mission::Placement placement = mission::Placement::kBest;
  bool any = false;  ///< tasks of `added` that cannot be planned may be left out
  /// The id for the first part of a mapping; absent: no mapping may be flown in parts.
  std::optional<mission::GoalId> part = {};
};

/// One order of high-level tasks that was tried.
struct Trial {
  mission::Placement placement = mission::Placement::kLast;
  std::vector<mission::GoalId> order;
  double part = 0;  ///< share of a mapping's lanes flown ahead of other tasks; 0: not in parts
  bool feasible = false;
  double cost = 0;                         ///< of the plan, if there is one
  Duration shortened;                      ///< by how much it shortens durations given as ranges
  std::vector<std::string> reasons;        ///< why it is not feasible
  std::optional<mission::GoalId> culprit;  ///< the task that makes it infeasible, if it is one task
};

struct InsertionOutcome {
  /// The plan of the best feasible order of `planned` and `added`. Absent: no order is feasible.
  std::optional<mission::ElementaryPlan> plan;
  std::vector<mission::HighLevelTask> order;
  mission::Placement chosen = mission::Placement::kLast;
  Schedule schedule;  ///< of `standing` and the plan together
  std::vector<Shortened> shortened;
  /// Without a plan: changes of bounds that would make all that was asked for feasible. Empty: no
  /// change of bounds helps, or none was looked for.
  std::vector<Relaxation> relaxations;
  /// Tasks of `added` that the plan leaves out; without a plan, the tasks that prevent one.
  std::vector<Dropped> dropped;
  std::vector<Trial> trials;
  std::vector<std::string> reasons;  ///< why there is no plan: those of all trials, each once
};

/// Tries the placements that the request allows (spec 6.2 (1)): (a) after all planned tasks, (b) by
/// temporal compatibility with absolute constraints, (c) by spatial compatibility: a tour over the
/// places of the tasks that may be reordered. Plans each order and keeps the one of least cost that
/// is dynamically controllable and does not touch the energy reserve; of equal ones the first.
/// Takeoffs stay first, landings and waits for orders last. kFirst: added before planned. Tasks
/// without a place stay behind their predecessor; tasks that synchronise keep their order. If
/// nothing was planned before, the mission is planned in its own order, except with kTour.
///
/// An order that lacks time or energy shortens the durations given as ranges, all by the same
/// fraction of their range; an order that shortens less is preferred to a cheaper one. If absolute
/// bounds leave no other place, kBest and kInTime may put the new tasks between two parts of a
/// mapping that has not begun: the share of lanes flown first is found by bisection, to eighths, as
/// large as feasible; the first part is a task of its own (kMapPart) in the order. A job. Source:
/// T IV.4.2 (SCD-1).
InsertionOutcome insert_tasks(const InsertionRequest& request);

}  // namespace skein::supervisor
