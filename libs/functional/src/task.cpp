// SPDX-License-Identifier: Apache-2.0
#include "skein/functional/task.hpp"

#include <array>
#include <utility>

namespace skein::functional {

namespace {

constexpr std::array<std::pair<TaskState, std::string_view>, 6> kStates{
    {{TaskState::kScheduled, "scheduled"},
     {TaskState::kStarted, "started"},
     {TaskState::kRunning, "running"},
     {TaskState::kAborting, "aborting"},
     {TaskState::kEnded, "ended"},
     {TaskState::kAborted, "aborted"}}};

}  // namespace

std::string_view to_text(TaskState state) {
  for (const auto& [one, word] : kStates) {
    if (one == state) return word;
  }
  return "?";
}

std::string_view to_text(AbortCause cause) {
  switch (cause) {
    case AbortCause::kOther:
      return "other";
    case AbortCause::kRequested:
      return "requested";
    case AbortCause::kNoAir:
      return "no-air";
  }
  return "?";
}

std::optional<TaskState> task_state_from(std::string_view text) {
  for (const auto& [state, word] : kStates) {
    if (word == text) return state;
  }
  return std::nullopt;
}

}  // namespace skein::functional
