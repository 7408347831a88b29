// SPDX-License-Identifier: Apache-2.0
// Goals that the supervisor adds by itself (landings, leaving closed air), reported like all
// others.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>

#include "book/outbox.hpp"

namespace skein::supervisor {

/// Makes such goals, numbers them, and puts them first in the order. Lifetime: refers to its
/// arguments.
class OwnGoals {
 public:
  OwnGoals(const Knowledge& knowledge, Book& book, Outbox& out)
      : knowledge_(knowledge), book_(book), out_(out) {}

  /// Whether the domain declares this task.
  bool can_plan(std::string_view task) const;
  /// A new goal, not entered in the book yet; absent if the domain does not declare the task.
  std::optional<mission::HighLevelTask> next(std::string_view name) const;
  GoalId enter(const mission::HighLevelTask& task);
  /// So many may have been entered in a life of which nothing is known.
  void number_beyond(std::uint64_t given) { given_ = std::max(given_, given); }

 private:
  const Knowledge& knowledge_;
  Book& book_;
  Outbox& out_;
  std::uint64_t given_ = 0;  ///< how many were entered
};

}  // namespace skein::supervisor
