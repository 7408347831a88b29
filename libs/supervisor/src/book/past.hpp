// SPDX-License-Identifier: Apache-2.0
// What was settled long ago, and is let go.
#pragma once

#include <cstddef>

#include "book/book.hpp"

namespace skein::supervisor {

/// Of the goals that are settled, so many are kept: the last ones.
struct Kept {
  std::size_t goals = 0;     ///< in the plan, for reports
  std::size_t tasks_of = 0;  ///< of those with their tasks, which each input goes through
  std::size_t bare = 256;    ///< of those that left the plan, with how and when they were settled
};

/// Of the goals that are settled all but the last leave the plan, and of some more the tasks go,
/// the oldest first, as far as nothing open names them or is a whole of which they are parts, and
/// the executive has nothing of them. That there was a goal of that number stays known, how and
/// when it was settled of the last `bare`. Nothing is done before a quarter more than is kept are
/// settled. Precondition: no job is under way: its premises name tasks. Cost: linear in goals and
/// tasks.
void let_go_of_the_past(Book& book, Kept kept);

}  // namespace skein::supervisor
