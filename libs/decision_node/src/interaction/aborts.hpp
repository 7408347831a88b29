// SPDX-License-Identifier: Apache-2.0
// Why tasks of roles are aborted on board.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>

#include "skein/executive/task.hpp"

namespace skein::decision_node {

/// Who aborts a task of a role: of several reasons the first one listed decides.
enum class AbortedFor : std::uint8_t {
  kRole,    ///< the role has no use for it any more
  kAnew,    ///< it is begun again at once, as another one
  kAir,     ///< air closes on its way
  kNothing  ///< it would be flown in vain: its device has failed
};

/// The tasks of roles that this node aborts and of which it has not heard since that they are over.
/// Of other tasks that come to an end early the executive or the vehicle says why. A value.
class Aborts {
 public:
  /// To be called before the executive is told.
  void note(executive::TaskId task, AbortedFor why) {
    const auto [noted, is_new] = why_.try_emplace(task, why);
    if (!is_new) noted->second = std::min(noted->second, why);
  }
  /// Absent: it is not aborted here.
  std::optional<AbortedFor> of(executive::TaskId task) const {
    const auto noted = why_.find(task);
    return noted == why_.end() ? std::nullopt : std::optional(noted->second);
  }
  /// The task is over; it is forgotten.
  std::optional<AbortedFor> take(executive::TaskId task) {
    const auto why = of(task);
    why_.erase(task);
    return why;
  }

 private:
  std::map<executive::TaskId, AbortedFor> why_;
};

}  // namespace skein::decision_node
