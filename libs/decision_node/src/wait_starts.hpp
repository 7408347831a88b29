// SPDX-License-Identifier: Apache-2.0
// From when waits for partners count when a synchronisation is tried again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "partners.hpp"
#include "skein/executive/executive.hpp"

namespace skein::decision_node {

/// Who stops a wait and begins it again goes on with it: the next task of the same synchronisation
/// counts from the first one, if it begins at most kPlannedAgain after the end of the one before,
/// and that one was not met. A value.
class WaitStarts {
 public:
  /// The waits that there are; at least before each that ends.
  void see(const std::vector<executive::Wait>& waits, MissionTime now) {
    for (const executive::Wait& wait : waits) {
      const MissionTime since = start_of(wait);
      starts_[wait.synchronisation] = {wait.id, since, now};
    }
    std::erase_if(starts_, [&](const auto& one) { return one.second.last + kPlannedAgain < now; });
  }
  /// The task is over because all have come: the synchronisation that comes next is another one.
  void met(functional::TaskId task) {
    std::erase_if(starts_, [&](const auto& one) { return one.second.task == task; });
  }
  /// From when on partners are waited for; `wait.since` or earlier.
  MissionTime start_of(const executive::Wait& wait) const {
    const auto found = starts_.find(wait.synchronisation);
    if (found == starts_.end()) return wait.since;
    const Start& start = found->second;
    const bool goes_on = start.task == wait.id || wait.since <= start.last + kPlannedAgain;
    return goes_on ? std::min(start.since, wait.since) : wait.since;
  }

 private:
  struct Start {
    functional::TaskId task;  ///< that waited last
    MissionTime since, last;  ///< of the waits: the first instant, and the last that was seen
  };
  std::map<std::uint64_t, Start> starts_;  ///< by synchronisation
};

}  // namespace skein::decision_node
