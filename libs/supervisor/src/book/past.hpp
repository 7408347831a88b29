// SPDX-License-Identifier: Apache-2.0
// What was settled long ago, and is let go.
#pragma once

#include <cstddef>

#include "book/book.hpp"

namespace skein::supervisor {

/// Of the goals that are settled all but the last `kept` leave the plan, with their tasks, the
/// oldest first, as far as nothing open names them and the executive has nothing of them. That
/// there was a goal of that number stays known. Nothing is done before a quarter more than `kept`
/// are settled. Precondition: no job is under way: its premises name tasks. Cost: linear in goals
/// and tasks.
void let_go_of_the_past(Book& book, std::size_t kept);

}  // namespace skein::supervisor
