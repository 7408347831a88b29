// SPDX-License-Identifier: Apache-2.0
// What an operator asks of a UAV at degree 4: high-level tasks, in unit missions.
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

/// A high-level task, unique within the UAV for the whole mission. Chosen by who asks.
using GoalId = Id<struct GoalIdTag, std::uint64_t>;
/// A unit mission, likewise.
using MissionId = Id<struct MissionIdTag, std::uint64_t>;

/// Absolute bounds in mission time; absent: free. They hold for every elementary task that the
/// high-level task is refined into. Source: I III.B.1, spec 3.3.
struct TimeConstraints {
  std::optional<MissionTime> start_before, start_after, end_before, end_after;
  bool operator==(const TimeConstraints&) const = default;
  bool any() const { return start_before || start_after || end_before || end_after; }
};

/// A bound counted from another high-level task of the same UAV: every elementary task starts (or
/// ends) between `least` and `most` after that one ends. Void when that one fails or is cancelled.
struct GoalBound {
  GoalId goal;          ///< the other one
  bool on_end = false;  ///< of ends; else of starts
  Duration least;       ///< from 0
  Duration most = Duration::max();
  bool operator==(const GoalBound&) const = default;
};

/// An argument: a name (place, zone, UAV, device, word), a number in the unit of its parameter, a
/// location [m] ENU, or several names.
using Argument = std::variant<std::string, double, world::Vector3, std::vector<std::string>>;

/// (statement, parameters, absolute time constraints). Source: T def. IV.3.
struct HighLevelTask {
  GoalId id;
  std::string name;  ///< of a task of the planning domain: "perform-detection"
  std::vector<Argument> arguments;
  TimeConstraints time;
  std::vector<GoalBound> after = {};
  bool operator==(const HighLevelTask&) const = default;
};

/// "perform-detection Z2 P2 300", with the time constraints, if any, in seconds: for people.
std::string to_text(const HighLevelTask& task);

/// How a new mission is put among the high-level tasks already planned. Source: spec 6.2 (1).
enum class Placement : std::uint8_t {
  kBest,    ///< the best feasible of the others, kFirst apart
  kLast,    ///< (a) after all
  kInTime,  ///< (b) where absolute constraints leave room, in its order
  kTour,    ///< (c) by a tour over the places of all that is free to move
  kFirst    ///< urgent: before all that is not committed yet
};
/// "best", "last", "in-time", "tour", "first".
std::string_view to_text(Placement placement);
std::optional<Placement> placement_from(std::string_view text);

/// An ordered set of high-level tasks. The initial state is that of the UAV when it comes to them.
struct UnitMission {
  MissionId id;
  std::vector<HighLevelTask> tasks;  ///< in the order wanted
  Placement placement = Placement::kBest;
  bool interrupt = false;  ///< with kFirst: what is under way is interrupted and taken up after it
  /// What of it cannot be planned is left out, and the rest done; else it is all or nothing.
  bool any = false;
  std::string asked_by;  ///< who asked, for people: "step detection", "operator end"
  /// What it would cost is answered, and nothing else happens.
  bool evaluate = false;
  bool operator==(const UnitMission&) const = default;
};

/// Where a high-level task stands.
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
