// SPDX-License-Identifier: Apache-2.0
// Tasks that move from one executive to another, as requests to the one that gets them.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

/// What is known besides the tasks that move, which the executive that gets them may not know.
struct TransferFacts {
  /// Where another task of the UAV stands; nothing: unknown, or lost.
  std::function<std::optional<executive::TaskState>(executive::TaskId)> state_of;
  std::set<std::string> messages;  ///< the UAV has processed them
};

/// The requests, in order, that bring `tasks` into an executive that knows none of them and has
/// itself carried out, or heard of, nothing else. Laws:
/// - each task is started once, those under way first, then by id; what is under way has no
///   preconditions, and what was aborting is aborted;
/// - of conditions only what can still change is sent: clauses that hold for ever are left out,
///   literals that cannot hold any more too, and what is left has in the new executive, which sees
///   tasks under way begin again, the value it had in the old one;
/// - no condition names a task before its START: where it would, it follows as UPDATE-COND.
/// Source: spec 1.2 (hand-over), T III.1.3.
std::vector<Request> requests_to_start(std::vector<mission::HeldTask> tasks,
                                       const TransferFacts& facts);

/// The same request to an executive that does not know the tasks that `over` gives the terminal
/// state of: of the conditions only what can still change is sent. What `over` gives nothing for
/// stays as it is.
Request without_settled(
    const Request& request,
    const std::function<std::optional<executive::TaskState>(executive::TaskId)>& over);

}  // namespace skein::ground_station
