// SPDX-License-Identifier: Apache-2.0
#include "truth.hpp"

namespace skein::executive {

namespace {

// Whether a task in state `from` may yet come to state `to`, another one.
bool is_ahead(TaskState from, TaskState to) {
  switch (from) {
    case TaskState::kScheduled:
      return true;
    case TaskState::kStarted:
      return to != TaskState::kScheduled;
    case TaskState::kRunning:
      return to == TaskState::kAborting || is_terminal(to);
    case TaskState::kAborting:
      return is_terminal(to);  // `ended` cannot come, but is not settled either (spec 2.2)
    case TaskState::kEnded:
    case TaskState::kAborted:
      return false;
  }
  return false;
}

}  // namespace

Standing standing_of_task(TaskState current, TaskState wanted) {
  if (current == wanted) return is_terminal(current) ? Standing::kHoldsForEver : Standing::kHolds;
  return is_ahead(current, wanted) ? Standing::kNotNow : Standing::kNeverAgain;
}

}  // namespace skein::executive
