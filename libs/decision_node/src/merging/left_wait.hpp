// SPDX-License-Identifier: Apache-2.0
// A wait for orders or partners that the vehicle was stopped in to make room.
#pragma once

#include <optional>

#include "skein/functional/port.hpp"

namespace skein::decision_node {

/// It goes on at its executive, and not on the vehicle, which holds all the same where it gets out
/// of the way: how it ends there concerns nobody. A value.
class LeftWait {
 public:
  /// The vehicle was stopped in it.
  void leave(functional::TaskId wait) { left_ = wait; }
  /// Whether this task is the one that was left: for its executive it runs.
  bool is(functional::TaskId task) const { return left_ == task; }
  /// True: its executive had it still, and it is over now.
  bool drop(functional::TaskId task) {
    if (!is(task)) return false;
    left_.reset();
    return true;
  }
  /// Whether the vehicle only tells that it was stopped in it.
  bool hides(const functional::Status& status) const {
    return is(status.id) && functional::is_terminal(status.state);
  }

 private:
  std::optional<functional::TaskId> left_;
};

}  // namespace skein::decision_node
