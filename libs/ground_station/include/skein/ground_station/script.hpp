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
#include "skein/ground_station/alarm.hpp"
#include "skein/world/geometry.hpp"

namespace skein::ground_station {

// ---- when ----

struct Trigger;

/// Mission time has come to `at`.
struct AtTime {
  MissionTime at;
};
/// An alarm entered the state: raised and confirmed of any alarm, infirmed of the mission's subject
/// if it has one (see MissionPlanning).
struct OnAlarm {
  AlarmState state = AlarmState::kRaised;
};
/// The task entered the state, on board or, at degree 1, at the ground.
struct OnTask {
  std::string uav;
  executive::TaskId task;
  executive::TaskState state = executive::TaskState::kEnded;
};
/// An operator acted: scripted or live.
struct OnOperator {
  std::string does;
};
/// A step of the script was done.
struct OnStep {
  std::string step;
};
/// The decision node of the UAV restarted and lost its plan.
struct OnRestart {
  std::string uav;
};
/// All have happened, in any order.
struct AllOf {
  std::vector<Trigger> of;
};
/// One has happened.
struct AnyOf {
  std::vector<Trigger> of;
};

/// What happened once has happened: a leaf is remembered from the mission's start until its step is
/// done. AllOf nothing has happened at once, AnyOf nothing never does.
struct Trigger {
  std::variant<AtTime, OnAlarm, OnTask, OnOperator, OnStep, OnRestart, AllOf, AnyOf> what;
};

// ---- where ----

/// Points [m, ENU] known beforehand: coordinates, or a named place that the reader looked up.
struct AtPoints {
  std::vector<world::Vector3> points;
};
/// A point seen from the subject alarm's position.
struct NearAlarm {
  double bearing = 0;   ///< [rad] from the alarm, ENU counter-clockwise from east
  double distance = 0;  ///< [m] horizontal, >= 0
  double altitude = 0;  ///< [m] above the ground at that point
};
/// A boustrophedon. Each leg is level, `altitude` above the highest ground under it and under the
/// ways to its neighbours: the whole way clears the ground by as much.
struct OverZone {
  world::Polygon zone;
  double spacing = 0;         ///< [m] > 0
  double altitude = 0;        ///< [m] above ground
  bool around_alarm = false;  ///< begins at the leg nearest to the subject alarm
};
/// The subject alarm's position itself: what a camera is pointed at.
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
  std::vector<Target> targets;  ///< none: the task goes out as it is
};

/// Sends the tasks in order, one START each.
struct SendPlan {
  std::string uav;
  std::vector<PlannedTask> tasks;
};
/// Aborts the tasks, in order; without any, all that the board shows as not yet terminal, highest
/// id first (so that a cascade finds nothing to start).
struct AbortTasks {
  std::string uav;
  std::optional<std::vector<executive::TaskId>> tasks;
};
/// PROCESS-MSG.
struct SendMessage {
  std::string uav;
  std::string text;
};
/// UPDATE-COND: what is absent stays.
struct UpdateConditions {
  std::string uav;
  executive::UpdateConditions update;
};
/// The mission is over.
struct Finish {};

using Action = std::variant<SendPlan, AbortTasks, SendMessage, UpdateConditions, Finish>;

struct Step {
  std::string name;   ///< unique in the script
  std::string phase;  ///< entered with this step; empty: the phase stays
  Trigger when;
  Duration after;  ///< from the trigger to the actions, >= 0
  std::vector<Action> actions;
  bool once = true;  ///< else it is armed again after it was done, at most once per second
};

/// What an operator does during the mission: himself (`actions`), or by what steps make of it.
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

/// What is wrong with a script in itself, in sentences, all at once; empty when it is fine: step
/// names that are empty or twice there, triggers on unknown steps, negative delays. (Operators may
/// also act live, so any operator action may be waited for.)
std::vector<std::string> problems_of(const Script& script);

}  // namespace skein::ground_station
