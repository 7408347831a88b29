// SPDX-License-Identifier: Apache-2.0
// Changes of a UAV's degree of autonomy, hand-over of its plan, and outcomes of missions.
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

/// An operator's request to change the degree. Source: spec 1.2.
struct ChangeDegree {
  int degree = 3;
  bool interrupt = false;  ///< running tasks are interrupted and the UAV waits
  /// To degree 4 or 5: continue the high-level tasks that were handed over. Else they stay so.
  bool resume = true;
  bool operator==(const ChangeDegree&) const = default;
};

/// A task with its conditions, as an executive had it or would have received it.
struct HeldTask {
  executive::Task task;
  executive::TaskState state = executive::TaskState::kScheduled;
  bool in_executive = false;  ///< false: only planned; nobody carries it out until it is resumed
  GoalId origin;              ///< 0: not from a high-level task
  bool operator==(const HeldTask&) const = default;
};

/// Sent by the decision node at every change of degree: its plan at that moment, by id, without
/// tasks that are over.
struct HandOver {
  int degree = 3;  ///< the new degree
  std::vector<HeldTask> tasks;
  std::vector<GoalStatus> goals;
  bool operator==(const HandOver&) const = default;
};

/// A place becomes known, or is elsewhere than believed.
struct KnownPlace {
  std::string name;                            ///< an alarm's is "alarm:1" (name_of_alarm)
  world::Vector3 at = world::Vector3::Zero();  ///< [m] ENU
  double radius = 0;                           ///< of the object there [m]
  std::optional<world::CellState> cells = {};  ///< state of the ground within the radius
  std::optional<MissionTime> seen = {};  ///< of a moving object: time of `at`; absent: it is fixed
  bool operator==(const KnownPlace&) const = default;
};

/// Cells of the ground differ from what was believed. Absent fields stay unchanged.
struct KnownGround {
  std::string name;                 ///< for people
  world::Polygon area;              ///< [m] ENU; applies to the cells with their middle inside
  std::optional<double> risk = {};  ///< [0, 1]
  bool mapped = false;
  std::optional<world::CellState> cells = {};  ///< what burns or has burnt gives no risk any more
  bool operator==(const KnownGround&) const = default;
};

/// The world differs from what was believed: one change of air, place or ground. Source: spec 6.2
/// (6).
struct ChangeWorld {
  world::Volume volume;  ///< closed from now on; used if `place` and `ground` are absent
  bool remove = false;   ///< the volume of this name is open again; its other fields are ignored
  std::optional<KnownPlace> place = {};
  std::optional<KnownGround> ground = {};
  bool operator==(const ChangeWorld&) const = default;
};

/// "volume 'tower' closed", "place 'alarm:1' known", "ground of 'A' known": for people.
std::string to_text(const ChangeWorld& change);

/// Every reason why the change is invalid, in sentences; empty: it is valid.
std::vector<std::string> problems_of(const ChangeWorld& change);

/// Cancels some high-level tasks, those of a mission, or all. Source: spec 6.2 (2).
struct CancelGoals {
  std::vector<GoalId> goals;  ///< empty, with `mission` 0: all
  MissionId mission;          ///< 0: not by mission
  /// Tasks under way are interrupted; else they may end, and only the others are cancelled.
  bool interrupt = true;
  bool operator==(const CancelGoals&) const = default;
};

/// One application of an operator of the supervisor. Source: spec 6.2.
struct Decision {
  std::uint64_t number = 0;  ///< from 1, since the node's start
  std::string applied;       ///< "0 user request", "1 insert", …, "6 repair: shift"
  std::string cause;         ///< "mission 2 of operator", "task 104 overdue by 12.5 s"
  std::string inputs;        ///< "goals 701 702"
  std::string outcome;       ///< "plan 3, 12 tasks, ends between 512 and 640 s"; "refused: …"
  MissionTime began;
  Duration took;  ///< mission time until the outcome
  bool operator==(const Decision&) const = default;
};

/// Estimated cost of a mission if it were inserted into the present plan.
struct MissionEstimate {
  Placement placement = Placement::kLast;  ///< the placement that it would get
  double cost = 0;                         ///< additional cost, in the units of the domain
  double energy = 0;                       ///< additional energy [fraction of the full capacity]
  MissionTime earliest_end, latest_end;    ///< of its tasks; latest may be MissionTime::max()
  MissionTime plan_end;                    ///< latest end of the whole plan; may be max(), too
  bool operator==(const MissionEstimate&) const = default;
};

/// Outcome of the planning, or of the evaluation, of a mission that was accepted before.
struct MissionOutcome {
  MissionId mission;
  bool planned = false;                          ///< it has a plan; evaluated only: it could have
  std::vector<std::string> reasons;              ///< why it has none, all at once
  bool evaluated = false;                        ///< it was only evaluated: no plan was adopted
  std::optional<MissionEstimate> estimate = {};  ///< of an evaluation that found a plan
  bool operator==(const MissionOutcome&) const = default;
};

}  // namespace skein::mission
