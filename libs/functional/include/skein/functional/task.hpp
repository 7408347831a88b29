// SPDX-License-Identifier: Apache-2.0
// Identifiers of elementary tasks, whose range tells who made the task, and the states of a task.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "skein/foundation/id.hpp"

namespace skein::functional {

/// Unique within the UAV for the whole mission.
using TaskId = Id<struct TaskIdTag, std::uint64_t>;

/// Lower ids are for tasks of the ground station and of the supervisor. From here on: tasks for
/// roles of joint tasks that the ground station plays.
inline constexpr TaskId kFirstPlayedId{400'000'000};
/// From here on: tasks for roles of joint tasks that the UAV plays itself.
inline constexpr TaskId kFirstRoleId{500'000'000};
/// From here on: tasks that a decision node makes to keep its vehicle safe (see decision_node).
inline constexpr TaskId kFirstOwnId{1'000'000'000};
/// From here on: flights that a decision node puts in front of a task's own motion, to move aside or
/// to fly one portion of a sweep (decision 68). They are over before that motion runs.
inline constexpr TaskId kFirstAsideId{4'500'000'000'000'000};
/// From here on: background routines, numbered by the executive; requests must not use these ids.
/// (All of them are below 2^53, and so exact as JSON numbers.)
inline constexpr TaskId kFirstBackgroundId{9'000'000'000'000'000};

/// Source: T III.1.1, spec 2.1. The transitions are in executive.hpp.
enum class TaskState : std::uint8_t {
  kScheduled,
  kStarted,
  kRunning,
  kAborting,
  kEnded,
  kAborted,
};

/// "scheduled", "started", …
std::string_view to_text(TaskState state);
std::optional<TaskState> task_state_from(std::string_view text);

/// Why a task was aborted, for decisions; the `reason` beside it is text for people.
enum class AbortCause : std::uint8_t {
  kOther,      ///< any other cause; the only one that a vehicle's functional layer reports
  kRequested,  ///< an ABORT
  kNoAir,      ///< its motion was given up, since for too long other UAVs left it no air
};

/// "other", "requested", "no-air".
std::string_view to_text(AbortCause cause);

/// Ended or aborted: there are no further transitions.
constexpr bool is_terminal(TaskState state) {
  return state == TaskState::kEnded || state == TaskState::kAborted;
}

/// Started, running or aborting: dispatched and not yet terminal.
constexpr bool is_active(TaskState state) {
  return state == TaskState::kStarted || state == TaskState::kRunning ||
         state == TaskState::kAborting;
}

}  // namespace skein::functional
