// SPDX-License-Identifier: Apache-2.0
// Goals that the supervisor gives itself, so that what it does unasked is seen like all the rest.
#include <algorithm>

#include "core.hpp"
#include "flight/landing_place.hpp"

namespace skein::supervisor {

namespace {

/// Beyond what people number their tasks with.
constexpr std::uint64_t kFirstOwn = 900'000'000;
constexpr double kElsewhere = 5;  // [m] from home

std::string at_text(const world::Vector3& at) {
  return "(" + std::to_string(std::lround(at.x())) + ", " + std::to_string(std::lround(at.y())) +
         ")";
}

}  // namespace

bool Supervisor::Core::can_plan(std::string_view task) const {
  return config_.knowledge->vocabulary.tasks.count(std::string(task)) != 0;
}

// The next one; it is not entered yet.
std::optional<mission::HighLevelTask> Supervisor::Core::own_task(std::string_view name) const {
  if (!can_plan(name)) return std::nullopt;
  std::uint64_t id = kFirstOwn + own_goals_ + 1;
  while (book_.goals.count(GoalId(id)) != 0) ++id;
  return mission::HighLevelTask{GoalId(id), std::string(name), {}, {}};
}

GoalId Supervisor::Core::enter_own(const mission::HighLevelTask& task) {
  ++own_goals_;
  Goal goal;
  goal.task = task;
  goal.asked_by = config_.knowledge->uav + " itself";
  Goal& entered = book_.goals.emplace(task.id, std::move(goal)).first->second;
  book_.order.insert(book_.order.begin(), task.id);
  set_state(entered, GoalState::kReceived);
  return task.id;
}

std::string Supervisor::Core::named(GoalId goal) const {
  const auto found = book_.goals.find(goal);
  const std::string what =
      found == book_.goals.end() ? "" : " (" + mission::to_text(found->second.task) + ")";
  return "goal " + to_text(goal) + what;
}

// Somewhere else than at home, and why.
void Supervisor::Core::tell_landing(const mission::ElementaryPlan& plan) {
  const world::Vector3& home = config_.knowledge->home;
  for (const mission::ElementaryTask& task : plan.tasks) {
    if (task.type != "land" || task.way.empty()) continue;
    const world::Vector3& at = task.way.back();
    if ((at - home).head<2>().norm() <= kElsewhere) continue;
    const auto why = landing_problem(*config_.knowledge, *world_, {now_}, home);
    notice(named(task.origin) + " lands at " + at_text(at) + ", not at home: " +
           why.value_or("there is no way home, or the energy does not last so far"));
  }
}

}  // namespace skein::supervisor
