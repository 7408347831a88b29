// SPDX-License-Identifier: Apache-2.0
// Whether a task list is well formed, and which tasks it holds.
#pragma once

#include <cstddef>
#include <vector>

#include "language/read_context.hpp"

namespace skein::htn {

/// A task as some task list has it.
struct TaskUse {
  Expression task;
  Term name;
  std::size_t arguments = 0;
  bool open = false;  ///< ends in a dot: at least so many arguments
};

/// Walks task lists of any nesting with its own stack.
class TaskChecker {
 public:
  explicit TaskChecker(const ReadContext& context) : context_(context) {}
  void check(Expression tasks);

  /// The tasks met so far, those with a variable for a name left out.
  const std::vector<TaskUse>& tasks() const { return tasks_; }

 private:
  void check_one(Expression tasks);
  void check_task(Expression task);
  void push_from(Expression begin);

  const ReadContext& context_;
  std::vector<Expression> open_;
  std::vector<TaskUse> tasks_;
};

}  // namespace skein::htn
