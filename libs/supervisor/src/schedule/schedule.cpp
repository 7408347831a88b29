// SPDX-License-Identifier: Apache-2.0
// Verdict and dates of a plan that nobody keeps.
#include "skein/supervisor/schedule.hpp"

#include <algorithm>

#include "schedule/plan_network.hpp"

namespace skein::supervisor {

Schedule schedule(const std::vector<mission::ElementaryTask>& tasks, const Observations& seen,
                  MissionTime now, const GoalBounds& bounds) {
  std::vector<TaskView> views;
  views.reserve(tasks.size());
  for (const mission::ElementaryTask& task : tasks) {
    const auto found = seen.find(task.id);
    views.push_back({&task, found == seen.end() ? Observation() : found->second});
  }
  std::sort(views.begin(), views.end(),
            [](const TaskView& a, const TaskView& b) { return a.task->id < b.task->id; });
  relate(views, bounds);
  PlanNetwork network;
  network.update(views, now);
  return network.schedule();
}

}  // namespace skein::supervisor
