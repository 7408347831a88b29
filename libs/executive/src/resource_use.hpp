// SPDX-License-Identifier: Apache-2.0
// Which active tasks use which exclusive resource.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "skein/executive/task_state.hpp"

namespace skein::executive {

/// The users of each exclusive resource. Resources are numbered at their first mention. A task uses
/// its resources from its dispatch until it is terminal.
class ResourceUse {
 public:
  std::uint32_t number_of(const std::string& resource) {
    const auto [place, is_new] =
        numbers_.emplace(resource, static_cast<std::uint32_t>(users_.size()));
    if (is_new) users_.emplace_back();
    return place->second;
  }
  void acquire(TaskId id, const std::vector<std::uint32_t>& resources) {
    for (const std::uint32_t resource : resources) users_[resource].insert(id);
  }
  void release(TaskId id, const std::vector<std::uint32_t>& resources) {
    for (const std::uint32_t resource : resources) users_[resource].erase(id);
  }
  const std::set<TaskId>& users_of(std::uint32_t resource) const { return users_[resource]; }
  /// The active tasks that use any of these resources.
  std::set<TaskId> users_of(const std::vector<std::uint32_t>& resources) const {
    std::set<TaskId> all;
    for (const std::uint32_t resource : resources) {
      all.insert(users_[resource].begin(), users_[resource].end());
    }
    return all;
  }

 private:
  std::unordered_map<std::string, std::uint32_t> numbers_;
  std::vector<std::set<TaskId>> users_;
};

}  // namespace skein::executive
