// SPDX-License-Identifier: Apache-2.0
// Numbers of the flights that nobody asked for.
#pragma once

#include "skein/foundation/rising.hpp"
#include "skein/functional/task.hpp"

namespace skein::decision_node {

/// Of flights out of the way and back, and of portions of sweeps. A value.
class OwnFlightIds {
 public:
  static bool has(functional::TaskId task) {
    return task >= functional::kFirstAsideId && task < functional::kFirstBackgroundId;
  }
  /// A later life of the node begins: the vehicle would tell of a flight of another life's number
  /// how that one ended.
  void begin_anew(MissionTime now) {
    next_ = functional::TaskId(functional::kFirstAsideId.value() + Rising::least(now));
  }
  functional::TaskId next() const { return next_; }
  /// The next one is used.
  functional::TaskId take() {
    const functional::TaskId taken = next_;
    next_ = functional::TaskId(next_.value() + 1);
    return taken;
  }

 private:
  functional::TaskId next_ = functional::kFirstAsideId;
};

}  // namespace skein::decision_node
