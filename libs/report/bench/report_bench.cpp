// SPDX-License-Identifier: Apache-2.0
// Reading and writing for a mission of three UAVs and for a swarm of 20 with 100,000 lines.
#include <benchmark/benchmark.h>

#include <sstream>

#include "skein/report/report.hpp"
#include "synthetic_mission.hpp"

namespace skein::report {
namespace {

const std::string& log_of(std::int64_t uavs) {
  static const std::string comets = testing::comets_journal();
  static const std::string swarm = testing::swarm_journal(20, 100'000, 1);
  return uavs == 3 ? comets : swarm;
}

SalvagedJournal read(std::int64_t uavs) {
  std::istringstream in(log_of(uavs));
  return salvage_journal(in, "events.jsonl");
}

void read_log(benchmark::State& state) {
  log_of(state.range(0));  // made on first use
  for (auto _ : state) benchmark::DoNotOptimize(read(state.range(0)));
  state.SetBytesProcessed(state.iterations() *
                          static_cast<std::int64_t>(log_of(state.range(0)).size()));
}
BENCHMARK(read_log)->Arg(3)->Arg(20)->Unit(benchmark::kMillisecond);

void write_page(benchmark::State& state) {
  const RunInfo info = state.range(0) == 3 ? testing::comets_info() : testing::swarm_info(20);
  const Journal journal = read(state.range(0)).journal;
  std::size_t size = 0;
  for (auto _ : state) size = html_report(info, journal).size();
  state.counters["page_MB"] = static_cast<double>(size) / 1e6;
}
BENCHMARK(write_page)->Arg(3)->Arg(20)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skein::report

BENCHMARK_MAIN();
