// SPDX-License-Identifier: Apache-2.0
// High-level tasks and unit missions: an operator's requests to a UAV at degree 4.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "skein/foundation/id.hpp"
#include "skein/foundation/time.hpp"
#include "skein/world/geometry.hpp"

namespace skein::mission {

/// Identifies a high-level task; unique within the UAV for the whole mission, chosen by the asker.
using GoalId = Id<struct GoalIdTag, std::uint64_t>;
/// Identifies a unit mission, in the same way.
using MissionId = Id<struct MissionIdTag, std::uint64_t>;

/// Absolute bounds in mission time; absent: free. They hold for every elementary task that the
/// high-level task is refined into. Source: I III.B.1, spec 3.3.
struct TimeConstraints {
  std::optional<MissionTime> start_before, start_after, end_before, end_after;
  bool operator==(const TimeConstraints&) const = default;
  bool any() const { return start_before || start_after || end_before || end_after; }
};

/// A bound counted from another high-level task of the same UAV: every elementary task starts (or
/// ends) between `least` and `most` after the other one ends. Void if the other one fails or is
/// cancelled.
struct GoalBound {
  GoalId goal;          ///< the other high-level task
  bool on_end = false;  ///< bounds the ends of the elementary tasks; else their starts
  Duration least;       ///< >= 0
  Duration most = Duration::max();
  bool operator==(const GoalBound&) const = default;
};

/// An argument: a name (place, zone, UAV, device, word), a number in the unit of its parameter, a
/// location [m] ENU, or several names.
using Argument = std::variant<std::string, double, world::Vector3, std::vector<std::string>>;

/// (statement, parameters, absolute time constraints). Source: T def. IV.3.
struct HighLevelTask {
  GoalId id;
  std::string name;  ///< of the task in the planning domain: "perform-detection"
  std::vector<Argument> arguments;
  TimeConstraints time;
  std::vector<GoalBound> after = {};
  bool operator==(const HighLevelTask&) const = default;
};

/// "perform-detection Z2 P2 300", with the time constraints, if any, in seconds: for people.
std::string to_text(const HighLevelTask& task);

/// How a new mission is inserted among the high-level tasks already planned. Source: spec 6.2 (1).
enum class Placement : std::uint8_t {
  kBest,    ///< the best feasible one of kLast, kInTime and kTour
  kLast,    ///< (a) after all planned tasks
  kInTime,  ///< (b) where absolute constraints leave room, in the mission's order
  kTour,    ///< (c) by a tour over the places of all tasks that may be reordered
  kFirst    ///< urgent: before all tasks that are not committed yet
};
/// "best", "last", "in-time", "tour", "first".
std::string_view to_text(Placement placement);
std::optional<Placement> placement_from(std::string_view text);

/// An ordered set of high-level tasks. Its initial state is that of the UAV when it begins them.
struct UnitMission {
  MissionId id;
  std::vector<HighLevelTask> tasks;  ///< in the order wanted
  Placement placement = Placement::kBest;
  bool interrupt = false;  ///< with kFirst: tasks under way are interrupted and resumed after it
  /// Tasks that cannot be planned are left out; else all tasks are planned, or none.
  bool any = false;
  std::string asked_by;  ///< the asker, for people: "step detection", "operator end"
  /// The mission is only evaluated: its cost is answered, and no plan is adopted.
  bool evaluate = false;
  bool operator==(const UnitMission&) const = default;
};

/// State of a high-level task.
enum class GoalState : std::uint8_t {
  kReceived,    ///< no plan yet
  kPlanned,     ///< in the plan, not begun
  kUnderWay,    ///< some of its elementary tasks have begun
  kAchieved,    ///< all of its elementary tasks have ended
  kFailed,      ///< one of them failed and nothing replaced it; or no plan has room for it
  kCancelled,   ///< by a user
  kHandedOver,  ///< the ground station decides on it now (degree below 4)
  kCount
};
/// "received", "planned", "under-way", "achieved", "failed", "cancelled", "handed-over".
std::string_view to_text(GoalState state);
std::optional<GoalState> goal_state_from(std::string_view text);
/// Achieved, failed or cancelled.
constexpr bool is_settled(GoalState state) {
  return state == GoalState::kAchieved || state == GoalState::kFailed ||
         state == GoalState::kCancelled;
}

/// One line of the status board of high-level tasks.
struct GoalStatus {
  GoalId id;
  MissionId mission;
  std::string statement;  ///< as to_text of the task
  GoalState state = GoalState::kReceived;
  std::string why;  ///< of failed and cancelled
  std::string asked_by;
  std::string done = {};  ///< to_text of its Progress, by tasks that are over
  bool operator==(const GoalStatus&) const = default;
};

}  // namespace skein::mission
