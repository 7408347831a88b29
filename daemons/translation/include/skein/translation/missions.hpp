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

/// A value of the domain, or the first invalid field. Precondition of readers: the sample satisfies
/// the rules of the wire (wire::find_violation).
template <class T>
using Read = Result<T, wire::Violation>;

/// "tasks[1].arguments[0]: a location has 3 numbers".
std::string to_text(const wire::Violation& violation);

// ---- commands; without their numbers ----

wire::MissionTask to_wire(const mission::HighLevelTask& task);
/// `path`: position of the task in the sample, for the violation.
Read<mission::HighLevelTask> from_wire(const wire::MissionTask& task, const std::string& path);

wire::RequestKind to_wire(mission::RequestKind kind);
mission::RequestKind from_wire(wire::RequestKind kind);

/// A name with spaces inside a "names" argument is split.
wire::MissionRequest to_wire(const mission::UnitMission& mission);
wire::MissionRequest to_wire(const mission::CancelGoals& cancel, const std::string& asked_by);
/// Refuses ids that are 0, which means none, and arguments that are not of their kind.
Read<std::variant<mission::UnitMission, mission::CancelGoals>> from_wire(
    const wire::MissionRequest& request);

wire::DegreeCommand to_wire(const mission::ChangeDegree& change, const std::string& asked_by);
/// Refuses degrees other than 1 to 5.
Read<mission::ChangeDegree> from_wire(const wire::DegreeCommand& command);

/// Levels beyond ±1e9 m, infinity too, are sent as ±1e9 m and come back as infinity.
wire::WorldChange to_wire(const mission::ChangeWorld& change);
/// Refuses a volume without name, area, height or time, and one that crosses itself.
Read<mission::ChangeWorld> from_wire(const wire::WorldChange& change);
/// An alarm as a place that missions may refer to, with the known state of the ground there.
mission::ChangeWorld change_of(const wire::Alarm& alarm);
/// A sighted object as a place, at its position when it was seen.
mission::ChangeWorld change_of(const wire::SeenObject& object);

// ---- reports of a UAV ----

wire::GoalEntry to_wire(const mission::GoalStatus& goal);
mission::GoalStatus from_wire(const wire::GoalEntry& goal);

wire::MissionOutcome to_wire(const std::string& uav, const mission::MissionOutcome& outcome);
mission::MissionOutcome from_wire(const wire::MissionOutcome& outcome);

wire::HandOver to_wire(const std::string& uav, const mission::HandOver& hand_over);
/// Refuses degrees other than 1 to 5, and tasks that are finished or not in the order of their ids.
Read<mission::HandOver> from_wire(const wire::HandOver& hand_over);

wire::Decision to_wire(const std::string& uav, const mission::Decision& decision);
mission::Decision from_wire(const wire::Decision& decision);

/// Leaves out content without a field on the wire: names, parameters, durations, time constraints,
/// cost. A path with more points than the wire permits is thinned evenly.
wire::MissionPlan to_wire(const std::string& uav, const mission::PlanReport& report);
/// Refuses duplicate ids, malformed paths, and dates with the latest before the earliest.
Read<mission::PlanReport> from_wire(const wire::MissionPlan& plan);

}  // namespace skein::translation
