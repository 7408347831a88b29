// SPDX-License-Identifier: Apache-2.0
// Tasks that contradict each other because of who may do them.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/auction/task.hpp"

namespace skein::auction {

/// A task for more members than may do it; or tasks that need the same member and fit in no order.
struct MemberConflict {
  std::vector<TaskNumber> tasks;         ///< of several none can be left out (if at most 14)
  std::string why;                       ///< every constraint that takes part [s]
  std::optional<MemberNumber> member{};  ///< needed for all of several tasks
};

/// All such conflicts of a lot if only `members` may ever bid. Ways between places take no time.
/// Tasks without dates (see contradictions()), and those that nobody may do, are in none with
/// others. Of more than 14 tasks that need one member only those are found that are too many for
/// some interval. Cost: the square of the tasks; for each member 2^14 × tasks at the most.
std::vector<MemberConflict> member_conflicts(const Lot& lot, const std::set<MemberNumber>& members);

}  // namespace skein::auction
