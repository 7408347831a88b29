// SPDX-License-Identifier: Apache-2.0
// Explains a UAV's elementary tasks: where they came from and how they ended, as text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "skein/foundation/result.hpp"
#include "skein/report/journal.hpp"

namespace skein::report {

/// Explains all elementary tasks of the UAV that were ever in its plan, or only `task`: the
/// high-level task and its requester, the HTN methods that led to it, start and stop conditions,
/// earliest and latest dates as planned when it started, and actual dates. Above the tasks: the
/// high-level tasks with their outcomes; below: the decisions that concern `task` (without `task`
/// all decisions of the UAV). For a task that a role of a joint task requested: joint task, role,
/// block, and the condition under which the block began. Fails, with the nearest name, for a UAV
/// that is not in the log, and for a task that was never planned nor requested by a role.
/// Precondition: the journal is in time order.
Result<std::string, Failure> explain(const Journal& journal, const std::string& uav,
                                     std::optional<std::uint64_t> task);

}  // namespace skein::report
