// SPDX-License-Identifier: Apache-2.0
// What a schedule costs, beside the plain consistency of the same network in the same run, by
// processor time: skein_schedule_bench [REPETITIONS]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <utility>
#include <vector>

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
  return 0;
}
