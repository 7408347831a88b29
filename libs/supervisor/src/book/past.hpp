// SPDX-License-Identifier: Apache-2.0
// Removal of goals that were settled long ago.
#pragma once

#include <cstddef>

#include "book/book.hpp"

namespace skein::supervisor {

/// How many of the most recently settled goals are kept.
struct Kept {
  std::size_t goals = 0;     ///< in the plan, for reports
  std::size_t tasks_of = 0;  ///< of those in the plan, with their tasks (each input visits these)
  std::size_t bare = 256;    ///< outside the plan, with how and when they were settled
};

/// Removes settled goals beyond `kept` from the plan, and the tasks of further ones, the oldest
/// first. Exempt are goals that an open goal names, parts of an open mapping, and goals with tasks
/// at the executive. Which ids there ever were stays known. Runs only when the settled goals exceed
/// what is kept by a quarter. Precondition: no job is under way, since its premises name tasks.
/// Cost: linear in goals and tasks.
void let_go_of_the_past(Book& book, Kept kept);

}  // namespace skein::supervisor
