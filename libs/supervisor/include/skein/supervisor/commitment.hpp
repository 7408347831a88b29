// SPDX-License-Identifier: Apache-2.0
// Operator 5: elementary tasks as tasks of the executive.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "skein/executive/input.hpp"
#include "skein/mission/elementary_plan.hpp"
#include "skein/supervisor/schedule.hpp"

namespace skein::supervisor {

/// Dependences become preconditions: (ENDED n) and (RUNNING n) mandatory, (OVER n) the optional
/// form of ended. So does (ENDED n) of a task n in `stopped`: what an exit condition interrupts is
/// aborted for the executive, never ended (spec 2.1). The dependences of its stop-task become exit
/// conditions (ended → optional), with its `end_after`, if any. Its other time constraints become
/// conditions on time: not before the date from which it may start (start_after, end_after), and
/// not later than the last date at which it may (start_before, end_before). A hold is a choice:
/// what it is on is over, or its date is past. Source: spec 2.7, 6.2 (5).
executive::Start to_start(const mission::ElementaryTask& task, const mission::TaskDates& dates,
                          const std::set<executive::TaskId>& stopped,
                          const std::vector<Hold>& holds = {});

/// The requests that give these tasks to the executive, all at one instant, in order. A START may
/// only name tasks that are there, but a wait may be stopped by the end of a later task: the exit
/// conditions of such a task follow as UPDATE-COND once all tasks are there; so do the
/// preconditions of one that a later task holds back, which until then waits for an instant that
/// never comes. `stopped` are the tasks the executive already has that have a stop; those among
/// `tasks` are known to be so. Precondition: `dates` has every task; dependences name earlier ones,
/// or ones that the executive has.
std::vector<executive::Input> to_requests(
    const std::vector<mission::ElementaryTask>& tasks,
    const std::map<executive::TaskId, mission::TaskDates>& dates,
    std::set<executive::TaskId> stopped, const Holds& holds = {});

}  // namespace skein::supervisor
