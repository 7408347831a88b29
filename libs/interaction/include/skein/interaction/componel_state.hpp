// SPDX-License-Identifier: Apache-2.0
// The states of componels of an execution automaton, and which states may follow.
#pragma once

#include <cstdint>
#include <string_view>

namespace skein::interaction {

/// State of a componel (block, task or coordination action). Source: T V.4.2, spec 7.2, 7.8.
enum class ComponelState : std::uint8_t {
  kNone,  ///< its parent has not activated it yet: every state is still possible
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

/// The state that a condition asks for.
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

/// Whether a componel that is not in the asked state may still reach it before its parent is
/// activated again: from scheduled all states except scheduled; from running aborting, aborted,
/// ended; from aborting aborted; from ended and aborted none.
bool may_reach(ComponelState state, AskedState asked);

}  // namespace skein::interaction
