// SPDX-License-Identifier: Apache-2.0
// Transfer of tasks from one executive to another, as requests to the receiving one.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

/// Facts besides the transferred tasks that the receiving executive may not know.
struct TransferFacts {
  /// State of another task of the UAV; absent: unknown, or lost.
  std::function<std::optional<executive::TaskState>(executive::TaskId)> state_of;
  std::set<std::string> messages;  ///< the UAV has processed them
};

/// Which tasks an executive is given before the others.
enum class FirstGiven { kUnderWay, kWaiting };

/// The requests, in order, that bring `tasks` into an executive without tasks or history. Laws:
/// - each task is started once, those that are `first` before the others, then by id; tasks under
///   way get no preconditions, and aborting ones are aborted;
/// - conditions are simplified to what can still change: clauses that are true for ever and
///   literals that can no longer be true are left out. The rest has the same value in the new
///   executive, which sees tasks under way begin again, as in the old one;
/// - no condition names a task before its START: such a condition follows as UPDATE-COND.
/// Source: spec 1.2 (hand-over), T III.1.3.
std::vector<Request> requests_to_start(std::vector<mission::HeldTask> tasks,
                                       const TransferFacts& facts,
                                       FirstGiven first = FirstGiven::kUnderWay);

/// The request for an executive that does not know the tasks for which `over` returns a terminal
/// state: conditions on these are simplified as in requests_to_start(). Other conditions stay.
Request without_settled(
    const Request& request,
    const std::function<std::optional<executive::TaskState>(executive::TaskId)>& over);

}  // namespace skein::ground_station
