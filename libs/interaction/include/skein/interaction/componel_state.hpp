// SPDX-License-Identifier: Apache-2.0
// The states of what an execution automaton is made of, and what may still follow each.
#pragma once

#include <cstdint>
#include <string_view>

namespace skein::interaction {

/// State of a componel (block, task or coordination action). Source: T V.4.2, spec 7.2, 7.8.
enum class ComponelState : std::uint8_t {
  kNone,  ///< its parent has not activated it: every state is possible
  kScheduled,
  kRunning,
  kAborting,  ///< told to stop, not yet confirmed
  kAborted,
  kEnded,
};

/// "none", "scheduled", …
std::string_view to_text(ComponelState state);

constexpr bool is_over(ComponelState state) {
  return state == ComponelState::kEnded || state == ComponelState::kAborted;
}

/// What a condition asks of a componel.
enum class AskedState : std::uint8_t {
  kScheduled,
  kRunning,
  kAborting,
  kAborted,
  kEnded,
  kOver,  ///< ended or aborted
};

/// "scheduled", …, "over".
std::string_view to_text(AskedState asked);

bool is_in(ComponelState state, AskedState asked);

/// Whether a componel that is not in the asked state may still come there before its parent is
/// activated again: from scheduled to all but scheduled; from running to aborting, aborted, ended;
/// from aborting to aborted; from ended and aborted nowhere.
bool may_reach(ComponelState state, AskedState asked);

}  // namespace skein::interaction
