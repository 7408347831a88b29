// SPDX-License-Identifier: Apache-2.0
// Why a UAV did what it did, as text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "skein/foundation/result.hpp"
#include "skein/report/journal.hpp"

namespace skein::report {

/// For each elementary task of the UAV that a plan ever held, or for one of them: its high-level
/// task and who asked for it, the methods that led to it, what it waited for and what ends it, and
/// its dates: earliest and latest as promised when it started, and the actual ones. Above them the
/// high-level tasks with what became of them; below, the decisions that concern the task (all of
/// the UAV's, when no task is named). A task that a role of a joint task asked for: joint task,
/// role, block, and the condition under which that began. Fails with the nearest name for a UAV
/// that is not in the log, and for a task that no plan ever held and no role asked for.
/// Precondition: the journal is in time order.
Result<std::string, Failure> explain(const Journal& journal, const std::string& uav,
                                     std::optional<std::uint64_t> task);

}  // namespace skein::report
