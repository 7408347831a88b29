// SPDX-License-Identifier: Apache-2.0
// What a perturbation costs: time, checks, memory; on the networks of the experiment and on a large
// one.
#include <benchmark/benchmark.h>

#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/temporal/stn_engine.hpp"
#include "skein/temporal/team_dates.hpp"
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

/// Of so many agents, each with ten tasks before each of four meetings, one with each of four
/// others: what is told when a plan changes.
std::vector<FrontierLink> plan_links(Random& random) {
  std::vector<FrontierLink> links;
  std::uint32_t before = Frontier::kPresent, inner = Frontier::arrival_of(4);
  const auto lasts = [&](std::uint32_t from, std::uint32_t to) {
    const auto least = static_cast<Ticks>(1 + random.below(60));
    const Ticks most = least + static_cast<Ticks>(random.below(60));
    links.push_back({from, to, least, most, most});
    links.push_back({to, from, kMinusInfinite, kMinusInfinite, -most});
  };
  for (std::size_t meeting = 0; meeting < 4; ++meeting) {
    for (int task = 0; task < 10; ++task) {
      links.push_back({before, inner, 0, 0, 0});
      lasts(inner, inner + 1);
      before = inner + 1;
      inner += 2;
    }
    links.push_back({before, Frontier::arrival_of(meeting), 0, 0, 0});
    links.push_back({Frontier::arrival_of(meeting), Frontier::end_of(meeting), 1, 1, 1});
    before = Frontier::end_of(meeting);
  }
  return links;
}

void BM_Frontier(benchmark::State& state) {
  Random random(6, "stn_bench");
  const auto links = plan_links(random);
  const std::size_t kept = Frontier::arrival_of(4);
  for (auto _ : state) benchmark::DoNotOptimize(eliminate(kept + 80, kept, links));
}
BENCHMARK(BM_Frontier)->Unit(benchmark::kMicrosecond);

/// What an agent of the team works out when it hears one of the others.
void BM_TeamDates(benchmark::State& state) {
  const auto agents = static_cast<std::size_t>(state.range(0));
  Random random(7, "stn_bench");
  TeamDates dates("0");
  const std::size_t kept = Frontier::arrival_of(4);
  for (std::size_t agent = 0; agent < agents; ++agent) {
    Frontier frontier;
    for (std::size_t i = 0; i < 4; ++i) {  // in one order for all
      const std::size_t first = (agent + i) % 2 == 0 ? agent : (agent + agents - 1) % agents;
      const std::vector<std::string> both{std::to_string(first),
                                          std::to_string((first + 1) % agents)};
      frontier.meetings.push_back({10 * i + 1000 * first, both, both});
    }
    frontier.arcs = eliminate(kept + 80, kept, plan_links(random));
    agent == 0 ? dates.say(frontier) : dates.hear(std::to_string(agent), frontier);
  }
  for (auto _ : state) benchmark::DoNotOptimize(dates.dates(MissionTime::seconds(5)));
}
BENCHMARK(BM_TeamDates)->Arg(2)->Arg(12)->Arg(100)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace skein::temporal

BENCHMARK_MAIN();
