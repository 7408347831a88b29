// SPDX-License-Identifier: Apache-2.0
// What a perturbation costs: time, checks, memory; on the networks of the experiment and on a large
// one.
#include <benchmark/benchmark.h>

#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/temporal/stn_engine.hpp"
#include "skein/temporal_lab/mastn_generator.hpp"

namespace skein::temporal {
namespace {

Stn stn_of(const Mastn& mastn) { return {mastn.nodes, 0, mastn.arcs}; }

/// One mode K scenario of the experiment on N agents of V = 20, L = 10, E = 4.
struct Experiment {
  Stn network;
  std::vector<Step> steps;
};

Experiment experiment(std::uint32_t agents, std::uint64_t seed) {
  const MastnShape shape{agents, 20, 10, 4};
  const Mastn mastn = generate_mastn(shape, 100 + seed);
  return {stn_of(mastn), make_scenario(mastn, chain_arcs(shape), {}, 7 + seed)};
}

/// Lanes of 20 tasks tied to the origin, with links between neighbouring lanes.
Stn large(std::uint32_t nodes) {
  Stn stn;
  stn.nodes.resize(nodes);
  Random random(3, "stn_bench");
  for (NodeIndex node = 1; node < nodes; ++node) {
    const bool first = node % 20 == 1;
    const auto slack = static_cast<Ticks>(random.below(20));
    stn.arcs.push_back({first ? 0 : node - 1, node, 10 - slack / 2, 30 + slack});
    if (node > 25) stn.arcs.push_back({node - 23, node, -200, 400});
  }
  return stn;
}

void BM_Perturbation(benchmark::State& state) {
  const Experiment e = experiment(static_cast<std::uint32_t>(state.range(0)), 0);
  const StnEngine initial = StnEngine::make(e.network).value();
  std::uint64_t checks = 0;
  std::uint64_t perturbations = 0;
  for (auto _ : state) {
    state.PauseTiming();
    StnEngine engine = initial;
    const std::uint64_t before = engine.checks();
    state.ResumeTiming();
    for (const Step& step : e.steps) {
      benchmark::DoNotOptimize(engine.set_arc({step.arc, step.min, step.max}));
    }
    checks += engine.checks() - before;
    perturbations += e.steps.size();
  }
  const auto count = static_cast<double>(perturbations);
  state.counters["checks"] = static_cast<double>(checks) / count;
  state.counters["s_per_perturbation"] =
      benchmark::Counter(count, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["s_per_50_checks"] = benchmark::Counter(
      static_cast<double>(checks) / 50, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_Perturbation)->Arg(2)->Arg(8)->Arg(16)->Unit(benchmark::kMicrosecond);

/// The checks of an engine built anew after each step, over those of the incremental one.
std::pair<std::uint64_t, std::uint64_t> full_and_incremental(const Experiment& e) {
  Stn network = e.network;
  StnEngine engine = StnEngine::make(network).value();
  const std::uint64_t built = engine.checks();
  std::uint64_t full = 0;
  for (const Step& step : e.steps) {
    network.arcs[step.arc].min = step.min;
    network.arcs[step.arc].max = step.max;
    engine.set_arc({step.arc, step.min, step.max});
    full += StnEngine::make(network).value().checks();
  }
  return {full, engine.checks() - built};
}

/// Over ten networks, as the experiment does.
void BM_FullRecomputation(benchmark::State& state) {
  for (auto _ : state) {
    std::uint64_t full = 0;
    std::uint64_t incremental = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const auto counts =
          full_and_incremental(experiment(static_cast<std::uint32_t>(state.range(0)), seed));
      full += counts.first;
      incremental += counts.second;
    }
    state.counters["full_over_incremental"] =
        static_cast<double>(full) / static_cast<double>(incremental);
  }
}
BENCHMARK(BM_FullRecomputation)
    ->Arg(2)
    ->Arg(8)
    ->Arg(16)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

void BM_PerturbationOfALargeNetwork(benchmark::State& state) {
  const Stn network = large(static_cast<std::uint32_t>(state.range(0)));
  StnEngine engine = StnEngine::make(network).value();
  Random random(5, "stn_bench");
  const std::uint64_t before = engine.checks();
  for (auto _ : state) {
    const auto arc = static_cast<ArcId>(random.below(network.arcs.size()));
    const Arc& old = network.arcs[arc];
    const auto by = static_cast<Ticks>(random.below(5));
    benchmark::DoNotOptimize(engine.set_arc({arc, old.min + by, old.max}));
    benchmark::DoNotOptimize(engine.set_arc({arc, old.min, old.max}));
  }
  const auto count = static_cast<double>(2 * state.iterations());
  const auto checks = static_cast<double>(engine.checks() - before);
  state.counters["checks"] = checks / count;
  state.counters["s_per_50_checks"] =
      benchmark::Counter(checks / 50, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["bytes_per_arc"] =
      static_cast<double>(engine.memory_bytes()) / static_cast<double>(network.arcs.size());
}
BENCHMARK(BM_PerturbationOfALargeNetwork)->Arg(320)->Arg(10'000)->Arg(100'000);

/// Tried and taken back, as the supervisor tries insertions.
void BM_TentativeChange(benchmark::State& state) {
  const Stn network = large(static_cast<std::uint32_t>(state.range(0)));
  StnEngine engine = StnEngine::make(network).value();
  Random random(5, "stn_bench");
  for (auto _ : state) {
    const auto arc = static_cast<ArcId>(random.below(network.arcs.size()));
    engine.checkpoint();
    benchmark::DoNotOptimize(engine.set_arc({arc, network.arcs[arc].min + 4, kInfinite}));
    engine.rollback();
  }
}
BENCHMARK(BM_TentativeChange)->Arg(320)->Arg(100'000);

void BM_Build(benchmark::State& state) {
  const Stn network = large(static_cast<std::uint32_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(StnEngine::make(network));
}
BENCHMARK(BM_Build)->Arg(320)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skein::temporal

BENCHMARK_MAIN();
