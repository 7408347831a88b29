// SPDX-License-Identifier: Apache-2.0
// Change of a UAV's degree of autonomy while it flies, and what is handed over with it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/executive/task.hpp"
#include "skein/mission/high_level_task.hpp"
#include "skein/world/volume.hpp"

namespace skein::mission {

inline constexpr int kLeastDegree = 1;
inline constexpr int kGreatestDegree = 4;  ///< of those that are built

/// Asked by an operator. Source: spec 1.2.
struct ChangeDegree {
  int degree = 3;
  bool interrupt = false;  ///< what runs is interrupted and the UAV waits
  /// Up to 4: go on with the high-level tasks that were handed over. Else they stay handed over.
  bool resume = true;
  bool operator==(const ChangeDegree&) const = default;
};

/// A task with its conditions, as it was in an executive or would have come to it.
struct HeldTask {
  executive::Task task;
  executive::TaskState state = executive::TaskState::kScheduled;
  bool in_executive = false;  ///< false: only planned; nobody carries it out until it is resumed
  GoalId origin;              ///< 0: not from a high-level task
  bool operator==(const HeldTask&) const = default;
};

/// Sent by the decision node at every change of degree: the plan it holds at that moment, in the
/// order of ids; tasks that are over are left out.
struct HandOver {
  int degree = 3;  ///< from now on
  std::vector<HeldTask> tasks;
  std::vector<GoalStatus> goals;
  bool operator==(const HandOver&) const = default;
};

/// A volume of air is closed, or opened again. Source: spec 6.2 (6): the world changed.
struct ChangeWorld {
  world::Volume volume;
  bool remove = false;  ///< the volume of that name is no longer there; the rest does not count
  bool operator==(const ChangeWorld&) const = default;
};

/// Cancels high-level tasks, those of a mission, or all. Source: spec 6.2 (2).
struct CancelGoals {
  std::vector<GoalId> goals;  ///< with `mission` 0 and none: all
  MissionId mission;          ///< 0: not by mission
  /// Those under way are interrupted; else they are left to end and only the others cancelled.
  bool interrupt = true;
  bool operator==(const CancelGoals&) const = default;
};

/// One application of an operator of the supervisor. Source: spec 6.2.
struct Decision {
  std::uint64_t number = 0;  ///< from 1, in one life of the node
  std::string applied;       ///< "0 user request", "1 insert", …, "6 repair: shift"
  std::string cause;         ///< "mission 2 of operator", "task 104 overdue by 12.5 s"
  std::string inputs;        ///< "goals 701 702"
  std::string outcome;       ///< "plan 3, 12 tasks, ends between 512 and 640 s"; "refused: …"
  MissionTime began;
  Duration took;  ///< mission time until the outcome
  bool operator==(const Decision&) const = default;
};

/// What a mission would cost if it were taken now, beside what is planned already.
struct MissionEstimate {
  Placement placement = Placement::kLast;  ///< where it would go
  double cost = 0;                         ///< that it adds, as the domain counts
  double energy = 0;                       ///< that it adds [fraction of what is held when full]
  MissionTime earliest_end, latest_end;    ///< of its tasks; latest may be MissionTime::max()
  MissionTime plan_end;                    ///< latest end of all; likewise
  bool operator==(const MissionEstimate&) const = default;
};

/// What became of a mission that was accepted for planning, or for evaluation, later than its
/// acceptance.
struct MissionOutcome {
  MissionId mission;
  bool planned = false;                          ///< of an evaluation: it could be
  std::vector<std::string> reasons;              ///< why not, all at once
  bool evaluated = false;                        ///< nothing was adopted
  std::optional<MissionEstimate> estimate = {};  ///< of an evaluation that found a plan
  bool operator==(const MissionOutcome&) const = default;
};

}  // namespace skein::mission
