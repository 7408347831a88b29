// SPDX-License-Identifier: Apache-2.0
// Operator 5: elementary tasks become tasks of the executive.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "skein/executive/input.hpp"
#include "skein/mission/elementary_plan.hpp"
#include "skein/supervisor/schedule.hpp"

namespace skein::supervisor {

/// The START of `task`. Its dependences become preconditions: (ENDED n) and (RUNNING n) mandatory,
/// (OVER n) as an optional "ended". (ENDED n) is optional, too, for a task n in `stopped`: the
/// executive counts a task that its exit condition interrupts as aborted, never as ended (spec
/// 2.1). The dependences of the task's stop-task become optional exit conditions, together with
/// `end_after`, if any. The time constraints become preconditions on time: not before the earliest
/// start (with start_after or end_after), not after the latest start (with start_before or
/// end_before). A hold becomes a disjunction: its task is over, or its date is past. Source: spec
/// 2.7, 6.2 (5).
executive::Start to_start(const mission::ElementaryTask& task, const mission::TaskDates& dates,
                          const std::set<executive::TaskId>& stopped,
                          const std::vector<Hold>& holds = {});

/// The requests that give `tasks` to the executive, to be sent in order at one instant. A START may
/// only name tasks that the executive has, but a wait may be stopped by the end of a later task:
/// such exit conditions follow as UPDATE-COND after all STARTs. So do the preconditions of a task
/// with a hold on a later task; until then its precondition is an instant that never comes.
/// `stopped`: tasks with a stop that the executive has already; those among `tasks` are added here.
/// Precondition: `dates` has every task; dependences name earlier tasks, or tasks that the
/// executive has.
std::vector<executive::Input> to_requests(
    const std::vector<mission::ElementaryTask>& tasks,
    const std::map<executive::TaskId, mission::TaskDates>& dates,
    std::set<executive::TaskId> stopped, const Holds& holds = {});

}  // namespace skein::supervisor
