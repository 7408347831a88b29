// SPDX-License-Identifier: Apache-2.0
// Task identifiers and task states, taken from the port to the vehicle (skein::functional).
#pragma once

#include "skein/functional/task.hpp"

namespace skein::executive {

using functional::AbortCause;
using functional::is_active;
using functional::is_terminal;
using functional::kFirstBackgroundId;
using functional::task_state_from;
using functional::TaskId;
using functional::TaskState;
using functional::to_text;

}  // namespace skein::executive
