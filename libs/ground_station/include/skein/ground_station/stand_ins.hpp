// SPDX-License-Identifier: Apache-2.0
// Tasks that stand for others, whose ids are used up.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

/// A task that was interrupted cannot be begun again under its id, which its executive knows as
/// over. It gets another id here, and scripts and operators go on to speak of the first one.
/// Deterministic. A value; not safe to share between threads. Cost of each call: O(log n) in the
/// stand-ins of the mission for each id and condition.
class StandIns {
 public:
  /// Gives new ids to those of the UAV's tasks whose id is used up; conditions of `tasks` on them
  /// follow.
  void stand_in(const std::string& uav, std::vector<mission::HeldTask>& tasks,
                const std::function<bool(executive::TaskId)>& is_used_up);
  /// The task that the script knows it as; absent: it stands for no other.
  std::optional<executive::TaskId> original_of(const std::string& uav,
                                               executive::TaskId task) const;
  /// The request about the tasks that now stand for those that it names.
  Request redirected(const std::string& uav, Request request) const;

  /// Up to functional::kFirstPlayedId.
  static constexpr std::uint64_t kFirstId = 300'000'000;

 private:
  using Key = std::pair<std::string, executive::TaskId>;
  executive::TaskId current(const std::string& uav, executive::TaskId task) const;
  void follow(const std::string& uav, executive::Formula& formula) const;

  std::map<Key, executive::TaskId> originals_;  ///< by stand-in
  std::map<Key, executive::TaskId> current_;    ///< stand-in by original
  std::uint64_t next_ = kFirstId;
};

}  // namespace skein::ground_station
