// SPDX-License-Identifier: Apache-2.0
#include "book/own_goals.hpp"

namespace skein::supervisor {

namespace {

/// Beyond what people number their tasks with.
constexpr std::uint64_t kFirstOwn = 900'000'000;

}  // namespace

bool OwnGoals::can_plan(std::string_view task) const {
  return knowledge_.vocabulary.tasks.count(std::string(task)) != 0;
}

std::optional<mission::HighLevelTask> OwnGoals::next(std::string_view name) const {
  if (!can_plan(name)) return std::nullopt;
  std::uint64_t id = kFirstOwn + given_ + 1;
  while (book_.knows(GoalId(id))) ++id;
  return mission::HighLevelTask{GoalId(id), std::string(name), {}, {}};
}

GoalId OwnGoals::enter(const mission::HighLevelTask& task) {
  ++given_;
  Goal goal;
  goal.task = task;
  goal.asked_by = knowledge_.uav + " itself";
  Goal& entered = book_.goals.emplace(task.id, std::move(goal)).first->second;
  book_.order.insert(book_.order.begin(), task.id);
  out_.set_state(entered, GoalState::kReceived);
  return task.id;
}

}  // namespace skein::supervisor
