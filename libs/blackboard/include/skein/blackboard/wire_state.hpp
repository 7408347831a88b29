// SPDX-License-Identifier: Apache-2.0
// Slots of class state: the last value is always there.
// Written by idl/generate_wire.py from idl/state.idl: change that, and run it.
// clang-format off
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "skein/blackboard/wire_common.hpp"

namespace skein::wire {

enum class Role : std::uint32_t {
  kGround,
  kDdn,
  kSim,
  kRunner,
  kSpy,
  kFunctional,
  kOperator,
  kCount
};
constexpr auto names_of(Role) {
  return std::to_array<std::string_view>({"ground", "ddn", "sim", "runner", "spy", "functional",
    "operator"});
}

/// Who is behind a node number. World channel, instance 0.
struct DirectoryEntry {
  SampleHeader header;
  std::string name;
  Role role = Role::kSpy;
  std::string vendor;  ///< the DDS implementation: "fastdds"
  bool ready = false;  ///< configured and waiting for the clock
  std::uint32_t process = 0;  ///< process id on its machine
  bool operator==(const DirectoryEntry&) const = default;
};
SKEIN_WIRE_FIELDS(DirectoryEntry, header, name, role, vendor, ready, process)

enum class ClockPhase : std::uint32_t {
  kHolding,
  kRunning,
  kFinished,
  kCount
};
constexpr auto names_of(ClockPhase) {
  return std::to_array<std::string_view>({"holding", "running", "finished"});
}

/// Mission time for everybody. World channel, instance 0. Source: spec 1.4.
struct Clock {
  SampleHeader header;
  std::int64_t time = 0;  ///< [ns] mission time when sent
  double rate = 1;  ///< mission seconds per second
  ClockPhase phase = ClockPhase::kHolding;
  bool operator==(const Clock&) const = default;
};
SKEIN_WIRE_FIELDS(Clock, header, time, rate, phase)

/// State of one directed radio channel, from the simulator; from and to 0: of every channel that no
/// other sample is about. World channel; the instance numbers the pair: from * 65536 + to.
struct LinkState {
  SampleHeader header;
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  bool up = false;
  std::int64_t latency = 0;  ///< [ns] of mission time
  double loss = 0;  ///< share of stream samples lost, in [0, 1]
  double capacity = 0;  ///< [bit/s] of mission time; 0: unlimited
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

/// Which version of an interaction model a node has. Source: spec 7.3.
struct ModelVersion {
  std::string model;  ///< type of the joint task
  std::uint64_t version = 0;
  bool operator==(const ModelVersion&) const = default;
};
SKEIN_WIRE_FIELDS(ModelVersion, model, version)

/// The plan a UAV holds, with the state of each task.
struct PlanBoard {
  SampleHeader header;
  std::string uav;
  std::uint8_t degree = 0;
  bool airborne = false;
  std::vector<TaskEntry> tasks;  ///< by id
  std::vector<ModelVersion> models;  ///< of joint tasks
  bool operator==(const PlanBoard&) const = default;
};
SKEIN_WIRE_FIELDS(PlanBoard, header, uav, degree, airborne, tasks, models)

/// The degree of decisional autonomy of a UAV and what it does out of contact. Source: spec 1.2.
struct AutonomyDegree {
  SampleHeader header;
  std::string uav;
  std::uint8_t degree = 0;  ///< 1 to 5
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
  bool committed = false;  ///< the executive has it
  std::vector<double> way;  ///< x, y, z of each point; empty: it does not fly
  std::string methods;  ///< from the high-level task down, separated by " > "
  bool operator==(const PlanEntry&) const = default;
};
SKEIN_WIRE_FIELDS(PlanEntry, id, type, origin, dependences, stop, earliest_start, latest_start,
    earliest_end, latest_end, committed, way, methods)

/// The elementary plan of a UAV at degree 4 with its high-level tasks. Source: spec 6.1.
struct MissionPlan {
  SampleHeader header;
  std::string uav;
  std::uint64_t revision = 0;  ///< from 1 in one life of the node
  std::int64_t made = 0;  ///< [ns]
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
  return std::to_array<std::string_view>({"loading", "loaded", "running", "leaving", "ended",
    "aborted", "not-loaded"});
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
  std::string subject;  ///< the same at all who take part
  std::uint64_t task = 0;  ///< of its own executive
  std::string model;  ///< type of the joint task
  std::string variant;
  std::uint64_t model_hash = 0;
  JointTaskPhase phase = JointTaskPhase::kLoading;
  std::string why;  ///< of kLeaving, kAborted, kNotLoaded
  std::vector<RoleHolder> holders;  ///< as agreed last
  std::vector<std::string> active_blocks;  ///< of its role
  std::vector<std::string> violated;  ///< spatial constraint models
  std::int64_t agreed_start = kNoInstant;  ///< [ns]
  std::vector<Parameter> left;  ///< of its share of an area
  bool operator==(const JointTaskState&) const = default;
};
SKEIN_WIRE_FIELDS(JointTaskState, header, uav, subject, task, model, variant, model_hash, phase,
    why, holders, active_blocks, violated, agreed_start, left)

struct BoardTask {
  std::uint64_t id = 0;
  std::string type;
  TaskState state = TaskState::kScheduled;
  std::string reason;
  std::int64_t since = 0;  ///< [ns]
  bool lost = false;  ///< its executive restarted before it was over
  bool at_ground = false;  ///< the ground station executes it
  bool operator==(const BoardTask&) const = default;
};
SKEIN_WIRE_FIELDS(BoardTask, id, type, state, reason, since, lost, at_ground)

struct BoardDecision {
  std::uint64_t number = 0;
  std::string applied;
  std::string cause;
  std::string outcome;
  std::int64_t began = 0;  ///< [ns]
  bool operator==(const BoardDecision&) const = default;
};
SKEIN_WIRE_FIELDS(BoardDecision, number, applied, cause, outcome, began)

/// State of a UAV as last received by the ground station, for operators. World channel; the
/// instance is the UAV's node number.
struct UavBoard {
  SampleHeader header;
  std::string uav;
  std::uint8_t degree = 0;
  bool reachable = false;
  bool airborne = false;
  std::string holder;  ///< operator who controls the UAV; empty: none
  std::string asker;  ///< operator who has asked the holder for control; empty: none
  std::int64_t passes_at = kNoInstant;  ///< [ns] when control passes to `asker` if not refused
  std::int64_t located_at = kNoInstant;  ///< [ns] time of position to energy; kNoInstant: unknown
  Vector3 position;  ///< [m] ENU
  Vector3 velocity;  ///< [m/s]
  double heading = 0;  ///< [rad]
  double energy = 0;  ///< remaining share, in [0, 1]
  std::uint32_t waiting = 0;  ///< number of unanswered commands
  std::uint32_t held = 0;  ///< number of tasks handed over to the ground that nobody executes
  bool operator==(const UavBoard&) const = default;
};
SKEIN_WIRE_FIELDS(UavBoard, header, uav, degree, reachable, airborne, holder, asker, passes_at,
    located_at, position, velocity, heading, energy, waiting, held)

/// Tasks, plan and goals of a UAV, like UavBoard.
struct UavTasks {
  SampleHeader header;
  std::string uav;
  std::vector<BoardTask> tasks;  ///< by id; of those that are over, the latest
  std::uint64_t revision = 0;  ///< of the plan below; 0: it has none
  std::vector<PlanEntry> plan;
  std::vector<GoalEntry> goals;
  std::vector<BoardDecision> decisions;  ///< the latest, oldest first
  bool operator==(const UavTasks&) const = default;
};
SKEIN_WIRE_FIELDS(UavTasks, header, uav, tasks, revision, plan, goals, decisions)

struct BoardAlarm {
  std::uint32_t id = 0;
  AlarmState state = AlarmState::kRaised;
  Vector3 position;
  double radius = 0;  ///< [m]
  double belief = 0;  ///< in [0, 1]
  std::uint32_t views = 0;
  std::int64_t first_seen = 0;  ///< [ns]
  std::int64_t last_seen = 0;  ///< [ns]
  bool operator==(const BoardAlarm&) const = default;
};
SKEIN_WIRE_FIELDS(BoardAlarm, id, state, position, radius, belief, views, first_seen, last_seen)

/// A volume of air that is closed; as in WorldChange.
struct BoardAir {
  std::string name;
  std::vector<double> corners;
  double floor = 0;
  double ceiling = 0;
  std::int64_t from = 0;
  std::int64_t until = kNever;
  bool operator==(const BoardAir&) const = default;
};
SKEIN_WIRE_FIELDS(BoardAir, name, corners, floor, ceiling, from, until)

/// A task of a global mission, as the team's book has it.
struct BoardTeamTask {
  std::uint64_t id = 0;
  std::string statement;
  std::string stage;  ///< for-sale, owned, granted, done, unsold
  std::vector<std::string> owners;
  std::string why;  ///< bids, silence, who put it back
  bool operator==(const BoardTeamTask&) const = default;
};
SKEIN_WIRE_FIELDS(BoardTeamTask, id, statement, stage, owners, why)

/// What the ground station knows of the mission, for operators. World channel, instance 0.
struct GroundBoard {
  SampleHeader header;
  std::string phase;
  bool finished = false;
  std::vector<std::string> uavs;  ///< whose boards there are
  std::vector<std::string> answers;  ///< that the script waits for from an operator
  std::vector<BoardAlarm> alarms;  ///< by id
  std::vector<BoardAir> air;  ///< closed since the start, by name
  std::vector<CommandEntry> commands;  ///< the latest, oldest first
  std::vector<BoardTeamTask> team;  ///< by id
  bool operator==(const GroundBoard&) const = default;
};
SKEIN_WIRE_FIELDS(GroundBoard, header, phase, finished, uavs, answers, alarms, air, commands, team)

}  // namespace skein::wire
