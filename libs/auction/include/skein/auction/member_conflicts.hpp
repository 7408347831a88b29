// SPDX-License-Identifier: Apache-2.0
// Tasks that contradict each other because of who may do them.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/auction/task.hpp"

namespace skein::auction {

/// A task for more members than may do it; or two tasks that need the same member and fit in
/// neither order.
struct MemberConflict {
  std::vector<TaskNumber> tasks;         ///< one or two
  std::string why;                       ///< every constraint that takes part [s]
  std::optional<MemberNumber> member{};  ///< needed for both of two tasks
};

/// All such conflicts of a lot if only `members` may ever bid. Ways between places take no time.
/// Tasks without dates (see contradictions()), and those that nobody may do, are in no pair. Cost:
/// the square of the tasks.
std::vector<MemberConflict> member_conflicts(const Lot& lot, const std::set<MemberNumber>& members);

}  // namespace skein::auction
