// SPDX-License-Identifier: Apache-2.0
// What becomes of a task under way when the functional layer has lost it.
#pragma once

#include "skein/functional/task_type.hpp"

namespace skein::functional {

/// Whether the task may be begun anew from where the vehicle then is, and comes to the same: others
/// say when it ends (an open wait, a device that is on until it is told), or all that counts is
/// that the vehicle stands on the ground after it. Of any other task what was done counts (a way, a
/// time of looking), and it fails: whoever planned it knows how to go on.
inline bool begins_anew(const TaskType& type) {
  return type.can_end(Ending::kByOrder) || type.can_end(Ending::kByStop) ||
         type.leaves == Leaves::kOnTheGround;
}

}  // namespace skein::functional
