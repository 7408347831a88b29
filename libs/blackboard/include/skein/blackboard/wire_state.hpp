// SPDX-License-Identifier: Apache-2.0
// Slots of class state: the last value is always there (idl/state.idl).
#pragma once

#include "skein/blackboard/wire_common.hpp"

namespace skein::wire {

enum class Role : std::uint32_t { kGround, kDdn, kSim, kRunner, kSpy, kFunctional, kCount };
constexpr auto names_of(Role) {
  return std::to_array<std::string_view>({"ground", "ddn", "sim", "runner", "spy", "functional"});
}

/// Who is behind a node number. World channel, instance 0.
struct DirectoryEntry {
  SampleHeader header;
  std::string name;
  Role role = Role::kSpy;
  std::string vendor;         ///< the DDS implementation: "fastdds"
  bool ready = false;         ///< configured and waiting for the clock
  std::uint32_t process = 0;  ///< process id on its machine
  bool operator==(const DirectoryEntry&) const = default;
};
SKEIN_WIRE_FIELDS(DirectoryEntry, header, name, role, vendor, ready, process)

enum class ClockPhase : std::uint32_t { kHolding, kRunning, kFinished, kCount };
constexpr auto names_of(ClockPhase) {
  return std::to_array<std::string_view>({"holding", "running", "finished"});
}

/// Mission time for everybody. World channel, instance 0. Source: spec 1.4.
struct Clock {
  SampleHeader header;
  std::int64_t time = 0;  ///< [ns] mission time when sent
  double rate = 1;        ///< mission seconds per second
  ClockPhase phase = ClockPhase::kHolding;
  bool operator==(const Clock&) const = default;
};
SKEIN_WIRE_FIELDS(Clock, header, time, rate, phase)

/// State of one directed radio channel, from the simulator. World channel; the instance numbers
/// the pair: from * 1000 + to.
struct LinkState {
  SampleHeader header;
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  bool up = false;
  std::int64_t latency = 0;  ///< [ns] of mission time
  double loss = 0;           ///< share of stream samples lost, in [0, 1]
  double capacity = 0;       ///< [byte/s]; 0: unlimited
  bool operator==(const LinkState&) const = default;
};
SKEIN_WIRE_FIELDS(LinkState, header, from, to, up, latency, loss, capacity)

struct TaskEntry {
  std::uint64_t id = 0;
  std::string type;
  TaskState state = TaskState::kScheduled;
  std::string reason;  ///< why it was aborted, if it was
  bool operator==(const TaskEntry&) const = default;
};
SKEIN_WIRE_FIELDS(TaskEntry, id, type, state, reason)

/// The plan a UAV holds, with the state of each task.
struct PlanBoard {
  SampleHeader header;
  std::string uav;
  std::uint8_t degree = 0;
  bool airborne = false;
  std::vector<TaskEntry> tasks;  ///< by id
  bool operator==(const PlanBoard&) const = default;
};
SKEIN_WIRE_FIELDS(PlanBoard, header, uav, degree, airborne, tasks)

/// The degree of decisional autonomy of a UAV and what it does out of contact. Source: spec 1.2.
struct AutonomyDegree {
  SampleHeader header;
  std::string uav;
  std::uint8_t degree = 0;     ///< 1 to 5
  std::string contact_policy;  ///< "continue", "hold", "return"
  bool operator==(const AutonomyDegree&) const = default;
};
SKEIN_WIRE_FIELDS(AutonomyDegree, header, uav, degree, contact_policy)

/// Where the mission stands, from the ground station.
struct MissionState {
  SampleHeader header;
  std::string phase;
  bool finished = false;
  std::string outcome;  ///< once finished
  bool operator==(const MissionState&) const = default;
};
SKEIN_WIRE_FIELDS(MissionState, header, phase, finished, outcome)

/// A task of a plan with its dates [ns]; kNever: unbounded.
struct PlanEntry {
  std::uint64_t id = 0;
  std::string type;
  std::uint64_t origin = 0;  ///< the high-level task it comes from
  std::vector<TaskDependence> dependences;
  std::vector<TaskDependence> stop;  ///< what ends it
  std::int64_t earliest_start = 0;
  std::int64_t latest_start = 0;
  std::int64_t earliest_end = 0;
  std::int64_t latest_end = 0;
  bool committed = false;   ///< the executive has it
  std::vector<double> way;  ///< x, y, z of each point; empty: it does not fly
  std::string methods;      ///< from the high-level task down, separated by " > "
  bool operator==(const PlanEntry&) const = default;
};
SKEIN_WIRE_FIELDS(PlanEntry, id, type, origin, dependences, stop, earliest_start, latest_start,
                  earliest_end, latest_end, committed, way, methods)

/// The elementary plan of a UAV at degree 4 with its high-level tasks. Source: spec 6.1.
struct MissionPlan {
  SampleHeader header;
  std::string uav;
  std::uint64_t revision = 0;    ///< from 1 in one life of the node
  std::int64_t made = 0;         ///< [ns]
  std::vector<PlanEntry> tasks;  ///< of goals that are not settled
  std::vector<GoalEntry> goals;  ///< settled ones first
  bool operator==(const MissionPlan&) const = default;
};
SKEIN_WIRE_FIELDS(MissionPlan, header, uav, revision, made, tasks, goals)

enum class JointTaskPhase : std::uint32_t {
  kLoading,
  kLoaded,
  kRunning,
  kLeaving,  ///< it is being interrupted
  kEnded,
  kAborted,
  kNotLoaded,
  kCount
};
constexpr auto names_of(JointTaskPhase) {
  return std::to_array<std::string_view>(
      {"loading", "loaded", "running", "leaving", "ended", "aborted", "not-loaded"});
}

struct RoleHolder {
  std::string uav;
  std::string role;
  bool operator==(const RoleHolder&) const = default;
};
SKEIN_WIRE_FIELDS(RoleHolder, uav, role)

/// Where a UAV stands in a joint task, for its partners and for the ground. The instance numbers
/// its joint tasks. Source: spec 7.2, 7.3.
struct JointTaskState {
  SampleHeader header;
  std::string uav;
  std::string subject;     ///< the same at all who take part
  std::uint64_t task = 0;  ///< of its own executive
  std::string model;       ///< type of the joint task
  std::string variant;
  std::uint64_t model_hash = 0;
  JointTaskPhase phase = JointTaskPhase::kLoading;
  std::string why;                         ///< of kLeaving, kAborted, kNotLoaded
  std::vector<RoleHolder> holders;         ///< as agreed last
  std::vector<std::string> active_blocks;  ///< of its role
  std::vector<std::string> violated;       ///< spatial constraint models
  std::int64_t agreed_start = kNoInstant;  ///< [ns]
  bool operator==(const JointTaskState&) const = default;
};
SKEIN_WIRE_FIELDS(JointTaskState, header, uav, subject, task, model, variant, model_hash, phase,
                  why, holders, active_blocks, violated, agreed_start)

}  // namespace skein::wire
