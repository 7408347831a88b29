// SPDX-License-Identifier: Apache-2.0
// Missions, plans, hand-over and changes of degree and world: wire to domain and back.
#pragma once

#include <string>
#include <variant>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/result.hpp"
#include "skein/mission/autonomy.hpp"
#include "skein/mission/elementary_plan.hpp"
#include "skein/mission/request.hpp"

namespace skein::translation {

/// A value of the domain, or the first field that makes no sense. What comes in keeps the rules of
/// the wire already (wire::find_violation).
template <class T>
using Read = Result<T, wire::Violation>;

/// "tasks[1].arguments[0]: a location has 3 numbers".
std::string to_text(const wire::Violation& violation);

// ---- commands; without their numbers ----

wire::MissionTask to_wire(const mission::HighLevelTask& task);
/// `path` is where it stands, for the violation.
Read<mission::HighLevelTask> from_wire(const wire::MissionTask& task, const std::string& path);

wire::RequestKind to_wire(mission::RequestKind kind);
mission::RequestKind from_wire(wire::RequestKind kind);

/// In "names" arguments, names with spaces in them come apart.
wire::MissionRequest to_wire(const mission::UnitMission& mission);
wire::MissionRequest to_wire(const mission::CancelGoals& cancel, const std::string& asked_by);
/// Refuses ids that are 0, which means none, and arguments that are not of their kind.
Read<std::variant<mission::UnitMission, mission::CancelGoals>> from_wire(
    const wire::MissionRequest& request);

wire::DegreeCommand to_wire(const mission::ChangeDegree& change, const std::string& asked_by);
/// Refuses degrees that are not built.
Read<mission::ChangeDegree> from_wire(const wire::DegreeCommand& command);

/// Levels beyond ±1e9 m, infinity too, are sent as ±1e9 m and come back as infinity.
wire::WorldChange to_wire(const mission::ChangeWorld& change);
/// Refuses a volume without name, area, height or time, and one that crosses itself.
Read<mission::ChangeWorld> from_wire(const wire::WorldChange& change);
/// An alarm as a place that missions may name, with what is known of the ground there.
mission::ChangeWorld change_of(const wire::Alarm& alarm);
/// Where it was when it was seen.
mission::ChangeWorld change_of(const wire::SeenObject& object);

// ---- what a UAV tells ----

wire::GoalEntry to_wire(const mission::GoalStatus& goal);
mission::GoalStatus from_wire(const wire::GoalEntry& goal);

wire::MissionOutcome to_wire(const std::string& uav, const mission::MissionOutcome& outcome);
mission::MissionOutcome from_wire(const wire::MissionOutcome& outcome);

wire::HandOver to_wire(const std::string& uav, const mission::HandOver& hand_over);
/// Refuses degrees that are not built, and tasks that are not in the order of their ids or are
/// over.
Read<mission::HandOver> from_wire(const wire::HandOver& hand_over);

wire::Decision to_wire(const std::string& uav, const mission::Decision& decision);
mission::Decision from_wire(const wire::Decision& decision);

/// What the wire has no field for is left out: names, parameters, durations, time constraints,
/// cost. Of a way with more points than the wire takes, points evenly chosen.
wire::MissionPlan to_wire(const std::string& uav, const mission::PlanReport& report);
/// Refuses ids given twice, ways that are no points, and dates with the latest before the earliest.
Read<mission::PlanReport> from_wire(const wire::MissionPlan& plan);

}  // namespace skein::translation
