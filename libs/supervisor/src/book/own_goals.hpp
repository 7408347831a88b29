// SPDX-License-Identifier: Apache-2.0
// Goals that the supervisor gives itself, so that what it does unasked is seen like all the rest.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "book/outbox.hpp"

namespace skein::supervisor {

/// Numbers them, and puts them before all others. Lifetime: refers to its arguments.
class OwnGoals {
 public:
  OwnGoals(const Knowledge& knowledge, Book& book, Outbox& out)
      : knowledge_(knowledge), book_(book), out_(out) {}

  /// The domain has this task.
  bool can_plan(std::string_view task) const;
  /// The next one, which is not entered yet; nothing when the domain has no such task.
  std::optional<mission::HighLevelTask> next(std::string_view name) const;
  GoalId enter(const mission::HighLevelTask& task);

 private:
  const Knowledge& knowledge_;
  Book& book_;
  Outbox& out_;
  std::uint64_t given_ = 0;  ///< so far
};

}  // namespace skein::supervisor
