// SPDX-License-Identifier: Apache-2.0
#include "interrupted.hpp"

#include <algorithm>
#include <set>

#include "skein/functional/task.hpp"

namespace skein::decision_node {

namespace {

using executive::TaskId;
using executive::TaskState;
using mission::HeldTask;

bool goes_on(TaskId id, const std::vector<HeldTask>& after) {
  return std::any_of(after.begin(), after.end(), [&](const HeldTask& one) {
    return one.task.id == id && one.state != TaskState::kAborting;
  });
}

bool ends_with_one_of(const std::set<TaskId>& tasks, const HeldTask& held) {
  for (const executive::Clause& clause : held.task.exit) {
    for (const executive::Literal& literal : clause) {
      const auto* named = std::get_if<executive::TaskInState>(&literal.condition);
      if (named != nullptr && tasks.contains(named->task)) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<HeldTask> interrupted_since(const std::vector<HeldTask>& before,
                                        const std::vector<HeldTask>& after) {
  std::vector<HeldTask> candidates;
  for (const HeldTask& one : before) {
    if (one.state != TaskState::kAborting && one.task.id < functional::kFirstPlayedId)
      candidates.push_back(one);
  }
  std::set<TaskId> interrupted;
  for (const HeldTask& one : candidates)
    if (!goes_on(one.task.id, after)) interrupted.insert(one.task.id);
  for (std::size_t known = 0; known != interrupted.size();) {
    known = interrupted.size();
    for (const HeldTask& one : candidates)
      if (ends_with_one_of(interrupted, one)) interrupted.insert(one.task.id);
  }
  std::erase_if(candidates,
                [&](const HeldTask& one) { return !interrupted.contains(one.task.id); });
  for (HeldTask& one : candidates) {
    one.state = TaskState::kScheduled;
    one.in_executive = false;
  }
  return candidates;
}

}  // namespace skein::decision_node
