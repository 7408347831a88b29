// SPDX-License-Identifier: Apache-2.0
// What to do with an active task that the functional layer has lost.
#pragma once

#include "skein/functional/task_type.hpp"

namespace skein::functional {

/// Whether a task of this type may be started again from where the vehicle then is, with the same
/// result: its end is decided elsewhere (an open wait, a device that is on until it is stopped), or
/// only its final condition matters (the vehicle is on the ground). In other tasks progress matters
/// (a way, a time of observation): they fail, and their planner decides how to continue.
inline bool begins_anew(const TaskType& type) {
  return type.can_end(Ending::kByOrder) || type.can_end(Ending::kByStop) ||
         type.leaves == Leaves::kOnTheGround;
}

}  // namespace skein::functional
