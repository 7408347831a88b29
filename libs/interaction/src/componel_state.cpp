// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/componel_state.hpp"

namespace skein::interaction {

std::string_view to_text(ComponelState state) {
  switch (state) {
    case ComponelState::kScheduled:
      return "scheduled";
    case ComponelState::kRunning:
      return "running";
    case ComponelState::kAborting:
      return "aborting";
    case ComponelState::kAborted:
      return "aborted";
    case ComponelState::kEnded:
      return "ended";
    case ComponelState::kNone:
      break;
  }
  return "none";
}

std::string_view to_text(AskedState asked) {
  switch (asked) {
    case AskedState::kScheduled:
      return "scheduled";
    case AskedState::kRunning:
      return "running";
    case AskedState::kAborting:
      return "aborting";
    case AskedState::kAborted:
      return "aborted";
    case AskedState::kEnded:
      return "ended";
    case AskedState::kOver:
      break;
  }
  return "over";
}

bool is_in(ComponelState state, AskedState asked) {
  switch (asked) {
    case AskedState::kScheduled:
      return state == ComponelState::kScheduled;
    case AskedState::kRunning:
      return state == ComponelState::kRunning;
    case AskedState::kAborting:
      return state == ComponelState::kAborting;
    case AskedState::kAborted:
      return state == ComponelState::kAborted;
    case AskedState::kEnded:
      return state == ComponelState::kEnded;
    case AskedState::kOver:
      break;
  }
  return is_over(state);
}

bool may_reach(ComponelState state, AskedState asked) {
  switch (state) {
    case ComponelState::kNone:
      return true;
    case ComponelState::kScheduled:
      return asked != AskedState::kScheduled;
    case ComponelState::kRunning:
      return asked != AskedState::kScheduled && asked != AskedState::kRunning;
    case ComponelState::kAborting:
      return asked == AskedState::kAborted || asked == AskedState::kOver;
    case ComponelState::kAborted:
    case ComponelState::kEnded:
      break;
  }
  return false;
}

}  // namespace skein::interaction
