// SPDX-License-Identifier: Apache-2.0
// The scripted ground side of a scenario, as plain data. The scenario reader fills it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/executive/condition.hpp"
#include "skein/executive/input.hpp"
#include "skein/executive/task.hpp"
#include "skein/foundation/time.hpp"
#include "skein/ground_orders/alarm.hpp"
#include "skein/ground_orders/messages.hpp"
#include "skein/mission/autonomy.hpp"
#include "skein/mission/high_level_task.hpp"
#include "skein/world/geometry.hpp"
#include "skein/world/volume.hpp"

namespace skein::ground_station {

// ---- when ----

struct Trigger;

/// Mission time has come to `at`.
struct AtTime {
  MissionTime at;
};
/// An alarm entered the state. Without `id`: kRaised and kConfirmed match any alarm, kInfirmed only
/// the mission's subject alarm, if there is one (see MissionPlanning).
struct OnAlarm {
  AlarmState state = AlarmState::kRaised;
  AlarmId id = {};  ///< 0: none in particular
};
/// The task entered the state, on board or, at degree 1, at the ground.
struct OnTask {
  std::string uav;
  executive::TaskId task;
  executive::TaskState state = executive::TaskState::kEnded;
};
/// An operator, scripted or live, did the action.
struct OnOperator {
  std::string does;
};
/// A step of the script was done.
struct OnStep {
  std::string step;
};
/// A command of the step expired: it was not delivered in its lifetime, or not answered. Whether it
/// was carried out is unknown.
struct OnExpired {
  std::string step;
};
/// The decision node of the UAV restarted and lost its plan.
struct OnRestart {
  std::string uav;
};
/// The ground station has had no radio contact with the UAV for `lasts`, since the mission's start
/// or since the loss of contact. Occurs once per silence; times at which the ground station itself
/// was down do not count.
struct OnSilence {
  std::string uav;
  Duration lasts;  ///< > 0
};
/// The unit mission came to the stage.
struct OnMission {
  std::string uav;
  mission::MissionId mission;
  MissionStage state = MissionStage::kPlanned;
};
/// The high-level task entered the state.
struct OnGoal {
  std::string uav;
  mission::GoalId goal;
  mission::GoalState state = mission::GoalState::kAchieved;
};
/// The UAV changed to this degree. The degree at the start is no change.
struct OnDegree {
  std::string uav;
  Degree degree = 1;
};
/// What the UAV's contact-loss policy interrupted is held at the ground station: goals at degrees 4
/// and 5, tasks at 2 and 3.
struct OnHeld {
  std::string uav;
};
/// A task of a global mission came to this stage in the team's book.
struct OnTeamTask {
  mission::GoalId task;
  auction::Stage stage = auction::Stage::kDone;
};
/// A global mission came to the stage.
struct OnGlobalMission {
  mission::MissionId mission;
  GlobalStage stage = GlobalStage::kDone;
};
/// All of the triggers have occurred, in any order.
struct AllOf {
  std::vector<Trigger> of;
};
/// One of the triggers has occurred.
struct AnyOf {
  std::vector<Trigger> of;
};

/// The occurrence of a leaf is remembered from the mission's start until its step is done. An empty
/// AllOf occurs at once, an empty AnyOf never.
struct Trigger {
  std::variant<AtTime, OnAlarm, OnTask, OnOperator, OnStep, OnExpired, OnRestart, OnSilence,
               OnMission, OnGoal, OnDegree, OnHeld, OnTeamTask, OnGlobalMission, AllOf, AnyOf>
      what;
};

// ---- where ----

/// Fixed points [m, ENU]: coordinates, or a named place looked up by the scenario reader.
struct AtPoints {
  std::vector<world::Vector3> points;
};
/// A point relative to the subject alarm's position.
struct NearAlarm {
  double bearing = 0;   ///< [rad] from the alarm, ENU counter-clockwise from east
  double distance = 0;  ///< [m] horizontal, >= 0
  double altitude = 0;  ///< [m] above the ground at that point
};
/// A boustrophedon over a zone. Each leg is level, `altitude` above the highest ground under it and
/// under the ways to its neighbour legs, so that the whole way clears the ground by `altitude`.
struct OverZone {
  world::Polygon zone;
  double spacing = 0;         ///< [m] > 0
  double altitude = 0;        ///< [m] above ground
  bool around_alarm = false;  ///< begins at the leg nearest to the subject alarm
};
/// The subject alarm's position itself, as the target of a camera.
struct TheAlarm {};

/// Resolved to points when the task is sent, into the task parameter `parameter` (flat: x, y, z,
/// …).
struct Target {
  std::variant<AtPoints, NearAlarm, OverZone, TheAlarm> where;
  std::string parameter;
};

// ---- what ----

struct PlannedTask {
  executive::Task task;
  executive::InsertionMode mode = executive::InsertionMode::kSeq;
  std::vector<Target> targets;  ///< empty: the task is sent unchanged
};

/// Sends the tasks in order, one START each.
struct SendPlan {
  std::string uav;
  std::vector<PlannedTask> tasks;
};
/// Aborts the tasks, in order. Absent: all tasks that the board shows as not terminal, highest id
/// first (so that the end of one task starts no other).
struct AbortTasks {
  std::string uav;
  std::optional<std::vector<executive::TaskId>> tasks;
};
/// PROCESS-MSG.
struct SendMessage {
  std::string uav;
  std::string text;
};
/// UPDATE-COND: absent conditions stay unchanged.
struct UpdateConditions {
  std::string uav;
  executive::UpdateConditions update;
};

/// An argument of a high-level task that becomes a location [m] ENU when the mission is sent.
struct ArgumentTarget {
  std::size_t task = 0;      ///< index of the mission's task, from 0
  std::size_t argument = 0;  ///< index of the argument that is replaced, from 0
  std::variant<TheAlarm, NearAlarm> where;
};
/// Sends a unit mission to a UAV at degree 4. An empty `mission.asked_by` becomes the step's or the
/// operator's name. Source: spec 6.2 (0), (1).
struct SendMission {
  std::string uav;
  mission::UnitMission mission;
  std::vector<ArgumentTarget> targets;
};
/// Cancels high-level tasks. Source: spec 6.2 (2).
struct CancelMission {
  std::string uav;
  mission::CancelGoals cancel;
};
/// Asks for a change of degree. Source: spec 1.2.
struct SetDegree {
  std::string uav;
  mission::ChangeDegree change;
};
/// Takes the UAV to degree 1: the ground station executes the tasks that the UAV had begun, and its
/// operator decides on the rest.
struct TakeInHand {
  std::string uav;
  bool interrupt = false;  ///< running tasks are interrupted
};
/// Returns the UAV to the degree that it had before it was last taken in hand.
struct GiveBack {
  std::string uav;
};
/// Starts the tasks of the plan that a UAV handed over, in the order of ids.
struct ResumePlan {
  std::string uav;
  std::vector<executive::TaskId> without = {};  ///< tasks that are discarded
};
/// Discards the plan that a UAV handed over.
struct DropPlan {
  std::string uav;
};
/// Tells UAVs that a volume of air is closed. Source: spec 6.2 (6).
struct CloseAir {
  world::Volume volume;
  std::vector<std::string> uavs = {};  ///< empty: all
};
/// Tells UAVs that the volume `name` is open again.
struct OpenAir {
  std::string name;
  std::vector<std::string> uavs = {};  ///< none: all
};
/// Tells UAVs of a change of a place or of the ground. Source: spec 4.1, 6.2 (6).
struct TellWorld {
  mission::ChangeWorld change;
  std::vector<std::string> uavs = {};  ///< none: all
};
/// Gives the team a global mission. An empty `mission.asked_by` becomes the step's or the
/// operator's name. Source: spec 6.3.
struct SendGlobalMission {
  team::GlobalMission mission;
  std::vector<ArgumentTarget> targets;
};
/// The mission is over.
struct Finish {};

using Action =
    std::variant<SendPlan, AbortTasks, SendMessage, UpdateConditions, SendMission, CancelMission,
                 SetDegree, TakeInHand, GiveBack, ResumePlan, DropPlan, CloseAir, OpenAir,
                 TellWorld, SendGlobalMission, DeclareLost, DeclareFound, PlayRole, Finish>;

struct Step {
  std::string name;   ///< unique in the script
  std::string phase;  ///< entered with this step; empty: the phase stays
  Trigger when;
  Duration after;  ///< from the trigger to the actions, >= 0
  std::vector<Action> actions;
  bool once = true;  ///< false: it is armed again after it was done, at most once per second
};

/// An action of a scripted operator during the mission, with its own `actions`; steps may also wait
/// for it (OnOperator).
struct OperatorAction {
  std::string does;
  Trigger when;
  Duration after;  ///< >= 0
  std::vector<Action> actions;
};

struct Script {
  std::vector<Step> steps;
  std::vector<OperatorAction> operators;
  Duration command_lifetime = Duration::milliseconds(60'000);  ///< of every request sent, > 0
};

/// The `asked_by` of commands that come from the step.
std::string asked_by_step(const std::string& step);

/// The errors of a script in itself, in sentences, all at once; empty when it is fine: empty or
/// duplicate step names, triggers on unknown steps, silences of no length, negative delays. (Since
/// operators may also act live, OnOperator may name any action.)
std::vector<std::string> problems_of(const Script& script);

}  // namespace skein::ground_station
