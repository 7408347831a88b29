// SPDX-License-Identifier: Apache-2.0
// Figures of the STNU part, by processor time: skein_stnu_bench [INSTANCES]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numeric>
#include <vector>

#include "skein/temporal/incremental_controllability.hpp"
#include "skein/temporal/stnu_execution.hpp"
#include "skein/temporal_lab/stnu_generator.hpp"

namespace skein::temporal {
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

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

Stnu instance(std::uint32_t nodes, bool broken, std::uint64_t seed) {
  Random random(seed);
  return generate_stnu({.nodes = nodes,
                        .contingent = nodes / 10,
                        .lanes = 5,
                        .extra_arcs_percent = 65,
                        .break_it = broken},
                       random);
}

void bench_checks(std::uint32_t nodes, bool broken, std::uint64_t instances) {
  std::vector<double> times;
  std::size_t edges = 0;
  for (std::uint64_t seed = 1; seed <= instances; ++seed) {
    const Stnu network = instance(nodes, broken, seed);
    edges = 2 * network.contingent.size();
    for (const Arc& arc : network.arcs)
      edges += (arc.min != kMinusInfinite ? 1U : 0U) + (arc.max != kInfinite ? 1U : 0U);
    times.push_back(timed([&] {
      const auto result = check_dynamic_controllability(network);
      if (!result || result->controllable == broken) std::puts("unexpected verdict");
    }));
  }
  std::printf("check n=%-5u m=%-6zu k=%-4u %-7s median %8.2f ms, worst %8.2f ms\n", nodes, edges,
              nodes / 10, broken ? "non-DC" : "DC", 1e3 * quantile(times, 0.5),
              1e3 * quantile(times, 1.0));
}

Ticks shifted(Ticks bound, Random& random) {
  if (bound == kInfinite || bound == kMinusInfinite) return bound;
  return bound + (static_cast<Ticks>(random.below(41)) - 20) * kTicksPerSecond;
}

/// Times a change kept up to date and the same network from scratch.
class Race {
 public:
  explicit Race(const Stnu& network) : check_(*IncrementalDc::create(network)) {}

  const Stnu& network() const { return check_.network(); }

  bool change(std::uint32_t arc, Ticks min, Ticks max) {
    bool answer = false;
    kept_.push_back(timed([&] { answer = check_.change_arc(arc, min, max)->controllable; }));
    scratch_.push_back(timed([&] {
      if (check_dynamic_controllability(network())->controllable != answer)
        std::puts("disagreement");
    }));
    controllable_ += answer ? 1U : 0U;
    return answer;
  }

  /// Not timed.
  void prepare(std::uint32_t arc, Ticks min, Ticks max) { (void)check_.change_arc(arc, min, max); }

  void print(const char* what) const {
    std::printf(
        "change n=%-5zu %-16s %zu, %zu controllable: incremental median %.1f us, mean %.1f us, p99 "
        "%.1f us; scratch mean %.1f us; ratio of means %.1f, of medians %.1f\n",
        network().nodes.size(), what, kept_.size(), controllable_, 1e6 * quantile(kept_, 0.5),
        1e6 * mean(kept_), 1e6 * quantile(kept_, 0.99), 1e6 * mean(scratch_),
        mean(scratch_) / mean(kept_), quantile(scratch_, 0.5) / quantile(kept_, 0.5));
  }

 private:
  static double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  }

  IncrementalDc check_;
  std::vector<double> kept_, scratch_;
  std::size_t controllable_ = 0;
};

/// Changes one bound of a random arc by up to 20 s either way; every fourth change puts one back
/// instead; what breaks the network is mended at once, as a planner would.
void bench_small_changes(std::uint32_t nodes, int changes) {
  const Stnu first = instance(nodes, false, 1);
  Race race(first);
  Random random(7);
  for (int i = 0; i < changes; ++i) {
    const auto index = static_cast<std::uint32_t>(random.below(first.arcs.size()));
    Arc arc = race.network().arcs[index];
    Ticks& bound = random.chance(0.5) ? arc.min : arc.max;
    bound = shifted(bound, random);
    if (i % 4 == 3 || arc.min > arc.max) arc = first.arcs[index];
    if (!race.change(index, arc.min, arc.max)) {
      race.change(index, first.arcs[index].min, first.arcs[index].max);
    }
  }
  race.print("small, random");
}

/// Narrows every third arc to half its window, then opens it again: nearly all of these matter.
void bench_large_changes(std::uint32_t nodes) {
  const Stnu first = instance(nodes, false, 1);
  Race narrowing(first);
  Race opening(first);
  for (std::uint32_t i = 0; i < first.arcs.size(); i += 3) {
    const Arc& arc = first.arcs[i];
    if (arc.min == kMinusInfinite || arc.max == kInfinite) continue;
    const Ticks quarter = (arc.max - arc.min) / 4;
    narrowing.change(i, arc.min + quarter, arc.max - quarter);
    narrowing.prepare(i, arc.min, arc.max);
    opening.prepare(i, arc.min + quarter, arc.max - quarter);
    opening.change(i, arc.min, arc.max);
  }
  narrowing.print("to half a window");
  opening.print("back from half");
}

/// Every input of whole executions, with the query for the next wake-up that goes with it.
void bench_dispatcher(std::uint32_t nodes) {
  const Stnu network = instance(nodes, false, 1);
  Result<DispatchableNetwork, StnuError> form = tl::unexpected(StnuError{});
  const double making = timed([&] { form = make_dispatchable(network); });
  std::vector<double> times;
  Random random(3);
  for (int i = 0; i < 10; ++i) {
    const Execution run =
        execute(*form, draw_durations(network, random), StartPolicy::kRandom, random);
    if (!run.complete || !run.violated.empty()) std::puts("violated");
    Dispatcher dispatcher(*form, MissionTime());
    dispatcher.handle(TimePassed{}, MissionTime());
    for (std::size_t e = 1; e < run.events.size(); ++e) {
      const ExecutionEvent& event = run.events[e];
      times.push_back(timed([&] {
        dispatcher.handle(event.observed ? DispatchInput(Observed{event.node})
                                         : DispatchInput(Executed{event.node}),
                          event.at);
        dispatcher.next_wakeup();
      }));
    }
  }
  std::printf(
      "dispatch n=%-5u form in %.1f ms (%zu edges, %zu waits); decision median %.2f us, p99 %.2f "
      "us, worst %.2f us\n",
      nodes, 1e3 * making, form->edges.size(), form->waits.size(), 1e6 * quantile(times, 0.5),
      1e6 * quantile(times, 0.99), 1e6 * quantile(times, 1.0));
}

void run(std::uint64_t instances) {
  for (const std::uint32_t nodes : {500U, 1000U, 2000U, 5000U}) {
    for (const bool broken : {false, true}) bench_checks(nodes, broken, instances);
  }
  for (const std::uint32_t nodes : {500U, 1000U, 2000U}) {
    bench_small_changes(nodes, 1000);
    bench_large_changes(nodes);
  }
  for (const std::uint32_t nodes : {200U, 500U, 1000U}) bench_dispatcher(nodes);
}

}  // namespace
}  // namespace skein::temporal

int main(int argc, char** argv) {
  skein::temporal::run(argc > 1 ? static_cast<std::uint64_t>(std::max(1, std::atoi(argv[1]))) : 15);
  return 0;
}
