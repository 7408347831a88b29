// SPDX-License-Identifier: Apache-2.0
// What a schedule costs, beside the plain consistency of the same network in the same run, by
// processor time, and what an event of a flight costs: skein_schedule_bench [REPETITIONS]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "schedule/plan_network.hpp"
#include "skein/supervisor/schedule.hpp"
#include "skein/temporal/stn_engine.hpp"
#include "testing/elementary_plans.hpp"
#include "testing/rebuilt_network.hpp"

namespace skein::supervisor {
namespace {

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template <class Work>
double timed(Work&& work) {
  const double begin = cpu_seconds();
  work();
  return cpu_seconds() - begin;
}

double median(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

// As the engine takes it: one arc between two nodes.
temporal::Stn merged(const temporal::Stnu& network) {
  std::vector<temporal::Arc> arcs = network.arcs;
  for (const auto& link : network.contingent)
    arcs.push_back({link.activation, link.contingent, link.min, link.max});
  std::map<std::pair<temporal::NodeIndex, temporal::NodeIndex>, temporal::Arc> by_nodes;
  for (const auto& arc : arcs) {
    auto& one = by_nodes.emplace(std::pair(arc.from, arc.to), arc).first->second;
    one.min = std::max(one.min, arc.min);
    one.max = std::min(one.max, arc.max);
  }
  temporal::Stn result{network.nodes, network.origin, {}};
  for (const auto& [nodes, arc] : by_nodes) result.arcs.push_back(arc);
  return result;
}

MissionTime half_way(MissionTime a, MissionTime b) {
  return a + Duration::nanoseconds((b - a).count() / 2);
}

// Every task starts and ends when it is due, durations half-way; each is an event.
class Course {
 public:
  explicit Course(const Tasks& plan) : plan_(plan) {
    const Schedule dates = schedule(plan, {}, MissionTime());
    for (const auto& task : plan) {
      const auto& one = dates.foreseen.at(task.id);
      const MissionTime start = half_way(one.earliest_start, one.latest_start);
      const MissionTime end = half_way(one.earliest_end, one.latest_end);
      events_.emplace(start, std::pair(task.id, false));
      events_.emplace(std::max(end, start + Duration::milliseconds(1)), std::pair(task.id, true));
    }
  }

  // What is over is no longer of the plan. Calls measure(views, now) at each event.
  template <class Measure>
  void play(Measure&& measure) {
    std::set<executive::TaskId> over;
    Observations seen;
    for (const auto& [now, event] : events_) {
      if (event.second) {
        over.insert(event.first);
      } else {
        seen[event.first].started = now;
      }
      std::vector<TaskView> views;
      for (const auto& task : plan_) {
        if (over.count(task.id) == 0) views.push_back({&task, seen[task.id]});
      }
      measure(views, now);
    }
  }

 private:
  const Tasks& plan_;
  std::multimap<MissionTime, std::pair<executive::TaskId, bool>> events_;
};

void bench_events(std::size_t tasks) {
  const Tasks plan = long_plan(tasks);
  Course course(plan);
  PlanNetwork kept;
  std::vector<double> living, rebuilt;
  bool same = true;
  course.play([&](const std::vector<TaskView>& views, MissionTime now) {
    living.push_back(timed([&] { kept.update(views, now); }));
    PlanNetwork fresh;
    rebuilt.push_back(timed([&] { fresh.update(views, now); }));
    same = same && fresh.schedule().controllable == kept.schedule().controllable;
  });
  std::printf(
      "tasks %4zu events %4zu  kept: median %7.3f ms, greatest %7.3f ms  from scratch: median "
      "%7.3f "
      "ms  (local %llu, from scratch %llu)%s\n",
      tasks, living.size(), 1e3 * median(living),
      1e3 * *std::max_element(living.begin(), living.end()), 1e3 * median(rebuilt),
      static_cast<unsigned long long>(kept.network().settled_locally()),
      static_cast<unsigned long long>(kept.network().settled_from_scratch()),
      same ? "" : "  UNEXPECTED VERDICT");
}

void bench(std::size_t tasks, int repetitions) {
  const Tasks plan = long_plan(tasks);
  const temporal::Stn network = merged(network_of(plan, {}, MissionTime()));
  std::vector<double> whole, plain;
  bool fine = true;
  for (int i = 0; i < repetitions; ++i) {
    plain.push_back(
        timed([&] { fine = temporal::StnEngine::make(network)->consistent() && fine; }));
    whole.push_back(timed([&] { fine = schedule(plan, {}, MissionTime()).controllable && fine; }));
  }
  std::printf(
      "tasks %4zu nodes %4zu arcs %5zu  schedule %8.3f ms  consistency %8.3f ms  ratio %5.1f%s\n",
      tasks, network.nodes.size(), network.arcs.size(), 1e3 * median(whole), 1e3 * median(plain),
      median(whole) / median(plain), fine ? "" : "  UNEXPECTED VERDICT");
}

}  // namespace
}  // namespace skein::supervisor

int main(int argc, char** argv) {
  const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 21;
  for (const std::size_t tasks : {30U, 150U, 300U}) skein::supervisor::bench(tasks, repetitions);
  for (const std::size_t tasks : {30U, 150U, 300U}) skein::supervisor::bench_events(tasks);
  return 0;
}
