// SPDX-License-Identifier: Apache-2.0
// An elementary task as everybody names it: its number, whose range tells who made it, and its
// states.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "skein/foundation/id.hpp"

namespace skein::functional {

/// Unique within the UAV for the whole mission.
using TaskId = Id<struct TaskIdTag, std::uint64_t>;

/// Below this the ground station's tasks and the supervisor's; from here on those that roles of
/// joint tasks ask for which the ground station plays.
inline constexpr TaskId kFirstPlayedId{400'000'000};
/// From here on those that roles ask for on board; from kFirstOwnId on those that a decision node
/// makes to keep its vehicle safe: see decision_node.
inline constexpr TaskId kFirstRoleId{500'000'000};
inline constexpr TaskId kFirstOwnId{1'000'000'000};
/// Background routine tasks are numbered by the executive from here on; a request may not use such
/// an id. (Every id of the range is exact as a JSON number, that is, below 2^53.)
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

/// Why a task was aborted, where somebody decides by it. Its reason, in words, is for people.
enum class AbortCause : std::uint8_t {
  kOther,      ///< whatever else: a vehicle's functional layer says nothing but this
  kRequested,  ///< an ABORT
  kNoAir,      ///< others left its motion no air for so long that it is given up
};

/// "other", "requested", "no-air".
std::string_view to_text(AbortCause cause);

/// Ended or aborted: no transition leaves it.
constexpr bool is_terminal(TaskState state) {
  return state == TaskState::kEnded || state == TaskState::kAborted;
}

/// Started, running or aborting: dispatched and not yet terminal.
constexpr bool is_active(TaskState state) {
  return state == TaskState::kStarted || state == TaskState::kRunning ||
         state == TaskState::kAborting;
}

}  // namespace skein::functional
