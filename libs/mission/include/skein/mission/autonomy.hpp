// SPDX-License-Identifier: Apache-2.0
// Change of a UAV's degree of autonomy while it flies, and what is handed over with it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/executive/task.hpp"
#include "skein/mission/degree.hpp"
#include "skein/mission/high_level_task.hpp"
#include "skein/world/ground_state.hpp"
#include "skein/world/volume.hpp"

namespace skein::mission {

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

/// A place is known from now on, or lies elsewhere than was thought.
struct KnownPlace {
  std::string name;                            ///< an alarm's is "alarm:1" (name_of_alarm)
  world::Vector3 at = world::Vector3::Zero();  ///< [m] ENU
  double radius = 0;                           ///< of what is there [m]
  std::optional<world::CellState> cells = {};  ///< what is known of the ground within the radius
  std::optional<MissionTime> seen = {};  ///< of what moves: when it was there; absent: it stays
  bool operator==(const KnownPlace&) const = default;
};

/// Cells of the ground are not as they were thought to be. What is absent stays.
struct KnownGround {
  std::string name;                 ///< for people
  world::Polygon area;              ///< [m] ENU; cells with their middle inside
  std::optional<double> risk = {};  ///< [0, 1]
  bool mapped = false;
  std::optional<world::CellState> cells = {};  ///< what burns or has burnt gives no risk any more
  bool operator==(const KnownGround&) const = default;
};

/// The world is not as it was thought to be: one of air, place, ground. Source: spec 6.2 (6).
struct ChangeWorld {
  world::Volume volume;  ///< of air, closed from now on, when neither of the others is there
  bool remove = false;   ///< the volume of that name is no longer there; the rest does not count
  std::optional<KnownPlace> place = {};
  std::optional<KnownGround> ground = {};
  bool operator==(const ChangeWorld&) const = default;
};

/// "volume 'tower' closed", "place 'alarm:1' known", "ground of 'A' known": for people.
std::string to_text(const ChangeWorld& change);

/// Every reason why it makes no sense, in sentences.
std::vector<std::string> problems_of(const ChangeWorld& change);

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
