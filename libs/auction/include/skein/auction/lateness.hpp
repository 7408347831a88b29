// SPDX-License-Identifier: Apache-2.0
// When a task that has no owner is too late for everybody.
#pragma once

#include <string>

#include "skein/auction/task.hpp"
#include "skein/foundation/time.hpp"

namespace skein::auction {

/// Whether who begins the task at `now`, or when it may be begun, ends it behind its deadline. Its
/// times count from the epoch of the mission. The holder of the token does not call it again, and
/// whoever knows the task knows that.
bool is_too_late(const Task& task, MissionTime now);

/// For people, of such a task: what its window was. The same at any time.
std::string why_too_late(const Task& task);

}  // namespace skein::auction
