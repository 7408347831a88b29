// SPDX-License-Identifier: Apache-2.0
// The statuses that one vehicle gives of its tasks.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "skein/sim/messages.hpp"

namespace skein::sim {

/// Remembers the last status of every task, so that a request that comes twice is answered, not
/// executed, twice.
class StatusBoard {
 public:
  explicit StatusBoard(std::string uav) : uav_(std::move(uav)) {}

  void tell(std::uint64_t task, FunctionalState state, std::string reason, MissionTime at,
            std::vector<Effect>& effects) {
    FunctionalStatus status{uav_, task, state, std::move(reason), at};
    effects.push_back(status);
    last_.insert_or_assign(task, std::move(status));
  }
  /// A task not begun yet, waiting for its pilot: known, though nothing was told.
  void note(std::uint64_t task) { last_.try_emplace(task); }
  bool knows(std::uint64_t task) const { return last_.count(task) > 0; }
  /// Tells again what was told last of a known task, if anything was.
  void repeat(std::uint64_t task, MissionTime at, std::vector<Effect>& effects) const {
    FunctionalStatus status = last_.at(task);
    if (status.uav.empty()) return;
    status.at = at;
    effects.push_back(std::move(status));
  }
  const std::string& uav() const { return uav_; }

 private:
  std::string uav_;
  std::map<std::uint64_t, FunctionalStatus> last_;
};

}  // namespace skein::sim
