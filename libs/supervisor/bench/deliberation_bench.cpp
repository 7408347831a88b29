// SPDX-License-Identifier: Apache-2.0
// How long deliberation takes: missions of 3, 10 and 30 high-level tasks in a world like those of
// the scenarios. Prints milliseconds of processor time of the one thread, the median of several
// runs, so that what else the machine does hardly counts:
//   domain: text to vocabulary; a job: insertion of two looks, with the domain compiled for it and
//   kept from before; problem: printed and read, and made of values; planning: plan_tasks; checks:
//   schedule; insertion: insert_tasks of the last third among the others, best placement; repair:
//   by re-refining, and by replanning all with 90 and with 30 % of the energy that the plan needs.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>

#include "flight/retreat.hpp"
#include "planning/problem.hpp"
#include "skein/foundation/random.hpp"
#include "skein/supervisor/deliberator.hpp"
#include "skein/supervisor/repair.hpp"
#include "testing/planning_lab.hpp"
#include "testing/problem_text.hpp"

namespace skein::supervisor {
namespace {

using Goals = std::vector<mission::HighLevelTask>;

constexpr int kRuns = 9;

double milliseconds(const std::function<void()>& work) {
  std::vector<double> times;
  for (int run = 0; run < kRuns; ++run) {
    const std::clock_t begin = std::clock();
    work();
    times.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  std::nth_element(times.begin(), times.begin() + kRuns / 2, times.end());
  return times[kRuns / 2];
}

/// Takeoff, shots and stays here and there, landing.
Goals mission_of(std::size_t count) {
  Random random(count, "mission");
  Goals goals = {{mission::GoalId(1), "general-takeoff", {}, {}}};
  for (std::uint64_t id = 2; id < count; ++id) {
    const world::Vector3 at(random.uniform(-300, 300), random.uniform(-300, 300), 40);
    goals.push_back({mission::GoalId(id), "general-combined-goto-and-takeshot", {at, 20.0}, {}});
  }
  goals.push_back({mission::GoalId(count), "general-land", {}, {}});
  return goals;
}

/// A village not to be flown over, in the middle of the field.
testing::PlanningLab lab_with_village() {
  testing::PlanningLab lab;
  world::Volume village;
  village.name = "village";
  village.polygon = {{60, 40}, {140, 60}, {120, 150}, {50, 120}};
  lab.world.volumes.push_back(village);
  lab.knowledge.vehicle.energy.capacity *= 100;
  return lab;
}

void measure_re_refining(const testing::PlanningLab& lab, const Goals& goals) {
  RepairRequest request;
  request.base = lab.request();
  request.failed = goals[1];
  request.failed_at = 1;
  request.remaining = goals;
  request.remaining.erase(request.remaining.begin() + 1);
  RepairOutcome outcome;
  const double took = milliseconds([&] { outcome = repair_plan(request); });
  std::printf("  repair of a failed task: %s %.1f ms\n", to_text(outcome.served).data(), took);
}

void measure_replanning(const testing::PlanningLab& lab, const Goals& goals, double energy) {
  RepairRequest request;
  request.base = lab.request();
  request.base.situation.energy = lab.knowledge.vehicle.energy.reserve + kSpareEnergy + energy;
  request.remaining = goals;
  RepairOutcome outcome;
  const double took = milliseconds([&] { outcome = repair_plan(request); });
  std::printf("  repair with too little energy: %s %.1f ms, %zu dropped\n",
              to_text(outcome.served).data(), took, outcome.dropped.size());
}

void measure(const testing::PlanningLab& lab, std::size_t count) {
  PlanningRequest request = lab.request();
  request.tasks = mission_of(count);
  PlanningEffort effort;
  const auto plan = plan_tasks(request, &effort);
  if (!plan) {
    std::printf("%zu tasks: no plan: %s\n", count, plan.error().reasons.front().c_str());
    return;
  }
  const double planning = milliseconds([&] { (void)plan_tasks(request); });
  const double checks = milliseconds([&] { (void)schedule(plan->tasks, {}, {}); });
  InsertionRequest insertion{lab.request(), {}, {}, {}, mission::Placement::kBest};
  const std::size_t cut = count - std::max<std::size_t>(count / 3, 1);
  insertion.planned.assign(request.tasks.begin(),
                           request.tasks.begin() + static_cast<std::ptrdiff_t>(cut));
  insertion.added.assign(request.tasks.begin() + static_cast<std::ptrdiff_t>(cut),
                         request.tasks.end());
  InsertionOutcome inserted;
  const double inserting = milliseconds([&] { inserted = insert_tasks(insertion); });
  InsertionRequest whole{lab.request(), {}, {}, request.tasks, mission::Placement::kBest};
  const double new_mission = milliseconds([&] { (void)insert_tasks(whole); });
  std::printf("%zu tasks: %zu elementary; planning %.1f ms (%llu refinements), checks %.2f ms\n",
              count, plan->tasks.size(), planning,
              static_cast<unsigned long long>(effort.refinements), checks);
  std::printf("  insertion: a new mission %.1f ms; a third among the others %.1f ms, %zu trials\n",
              new_mission, inserting, inserted.trials.size());
  measure_re_refining(lab, request.tasks);
  for (const double part : {0.9, 0.3}) measure_replanning(lab, request.tasks, part * plan->energy);
}

/// A wall across the field: most straight ways are closed.
testing::PlanningLab lab_with_wall() {
  testing::PlanningLab lab = lab_with_village();
  world::Volume wall;
  wall.name = "wall";
  wall.polygon = {{60, -300}, {90, -300}, {90, 300}, {60, 300}};
  wall.ceiling = 150;
  lab.world.volumes = {wall};
  return lab;
}

/// Places on both sides of the wall, none next to it.
Goals beside_the_wall(std::size_t count) {
  Goals goals = mission_of(count);
  for (std::size_t i = 1; i + 1 < goals.size(); ++i) {
    world::Vector3& at = std::get<world::Vector3>(goals[i].arguments[0]);
    if (at.x() > 30 && at.x() < 120) at.x() += 100;
  }
  return goals;
}

/// Perceptions of so many places on the ground, each from a viewpoint of its own.
Goals perceptions_of(std::size_t count) {
  Goals goals = mission_of(count);
  for (std::size_t i = 1; i + 1 < goals.size(); ++i)
    std::get<world::Vector3>(goals[i].arguments[0]).z() = 0;
  return goals;
}

/// What one of many small jobs of a flight takes.
void measure_jobs(const testing::PlanningLab& lab) {
  InsertionRequest request;
  request.base = lab.request();
  request.added = {{mission::GoalId(1), "perceive", {"P1", 30.0}, {}},
                   {mission::GoalId(2), "perceive", {"P2", 30.0}, {}}};
  Deliberator kept;
  const double anew = milliseconds([&] { (void)deliberate(request); });
  const double again = milliseconds([&] { (void)kept.deliberate(request); });
  PlanningRequest planning = request.base;
  planning.tasks = request.added;
  constexpr int kTimes = 200;
  const double text = milliseconds([&] {
    for (int i = 0; i < kTimes; ++i) {
      htn::TermStore store;
      Diagnostics errors;
      (void)testing::read_problem(testing::problem_text(planning, "request"), store, errors);
    }
  });
  const double values = milliseconds([&] {
    for (int i = 0; i < kTimes; ++i) {
      htn::TermStore store;
      (void)problem_of(planning, store);
    }
  });
  std::printf("a job: %.2f ms, with the domain kept %.2f ms\n", anew, again);
  std::printf("problem: printed and read %.1f us, of values %.1f us\n", text / kTimes * 1e3,
              values / kTimes * 1e3);
}

void measure_hard(const char* what, const testing::PlanningLab& lab, Goals goals) {
  PlanningRequest request = lab.request();
  request.tasks = std::move(goals);
  const auto plan = plan_tasks(request);
  if (!plan) {
    std::printf("%s: no plan: %s\n", what, plan.error().reasons.front().c_str());
    return;
  }
  const double planning = milliseconds([&] { (void)plan_tasks(request); });
  std::printf("%s: %zu elementary; planning %.1f ms\n", what, plan->tasks.size(), planning);
}

}  // namespace
}  // namespace skein::supervisor

int main() {
  const auto lab = skein::supervisor::lab_with_village();
  const double domain = skein::supervisor::milliseconds(
      [&] { (void)skein::supervisor::vocabulary_of(lab.knowledge.domain); });
  std::printf("domain: %.2f ms\n", domain);
  skein::supervisor::measure_jobs(skein::supervisor::testing::PlanningLab());
  std::fflush(stdout);
  for (const std::size_t count : {3UL, 10UL, 30UL}) skein::supervisor::measure(lab, count);
  skein::supervisor::measure_hard("30 tasks, a wall across", skein::supervisor::lab_with_wall(),
                                  skein::supervisor::beside_the_wall(30));
  skein::supervisor::measure_hard("28 places on the ground", lab,
                                  skein::supervisor::perceptions_of(30));
}
