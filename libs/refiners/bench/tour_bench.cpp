// SPDX-License-Identifier: Apache-2.0
// Tours within 50 ms of wall time, against nearest neighbour + 2-opt in the same run: mean and
// worst gap over the best known (TSPLIB: published; others: the best of all runs made here).
// Then whole tours between hills, with the ways on the voxels: how long, and how many ways.
//   skein_refiners_tour_bench [MILLISECONDS] [DIRECTORY WITH *.tsp AND tsplib_optima.txt]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "../test/tour/cases.hpp"
#include "../test/tour/worlds.hpp"

namespace {

using namespace std::chrono_literals;
using skein::refiners::Budget;
using skein::refiners::TourCost;
using skein::refiners::TourProblem;
using skein::refiners::test::TourCase;
using Clock = std::chrono::steady_clock;
using Order = std::vector<std::size_t>;

constexpr int kSeeds = 10;

Order nearest_neighbour(const TourProblem& problem) {
  Order left(problem.stops()), order;
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  while (!left.empty()) {
    const auto cost = [&](std::size_t to) {
      return order.empty() ? problem.from_start[to] : problem.cost(order.back(), to);
    };
    const auto next = std::min_element(
        left.begin(), left.end(), [&](std::size_t a, std::size_t b) { return cost(a) < cost(b); });
    order.push_back(*next);
    left.erase(next);
  }
  return order;
}

/// The plain one: every pair, until none improves.
TourCost two_opt(const TourProblem& problem) {
  Order order = nearest_neighbour(problem);
  const auto hop = [&](std::size_t i, std::size_t j, bool turned) {
    const std::size_t a = order[i], b = order[j];
    const TourCost before =
        i == 0 ? problem.from_start[turned ? b : a] : problem.cost(order[i - 1], turned ? b : a);
    const TourCost after = j + 1 == order.size() ? problem.to_end[turned ? a : b]
                                                 : problem.cost(turned ? a : b, order[j + 1]);
    return before + after;
  };
  for (bool improved = true; improved;) {
    improved = false;
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size(); ++j)
        if (hop(i, j, true) < hop(i, j, false)) {
          std::reverse(order.begin() + static_cast<std::ptrdiff_t>(i),
                       order.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          improved = true;
        }
  }
  return cost_of(problem, order);
}

struct Gaps {
  double sum = 0, worst = 0;
  int runs = 0;
  void add(TourCost cost, TourCost best) {
    const double gap = 100.0 * (static_cast<double>(cost) / static_cast<double>(best) - 1);
    sum += gap;
    worst = std::max(worst, gap);
    ++runs;
  }
};

skein::refiners::TourOrder timed(const TourProblem& problem, std::uint64_t seed,
                                 Clock::duration time) {
  const auto end = Clock::now() + time;
  Budget budget;
  budget.time_is_up = [end] { return Clock::now() >= end; };
  return solve_tour(problem, budget, seed);
}

struct Totals {
  Gaps ours, plain;
  double longest_ms = 0;
};

void measure(const TourCase& c, TourCost known, Clock::duration time, Totals& totals) {
  const TourProblem problem = skein::refiners::test::closed_tour(c);
  std::vector<TourCost> costs;
  double ms = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto begin = Clock::now();
    costs.push_back(timed(problem, seed, time).cost);
    ms = std::max(ms, std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  }
  const TourCost plain = two_opt(problem);
  TourCost best = known;
  if (known == 0) {
    best = timed(problem, 99, 20 * time).cost;
    for (const TourCost cost : costs) best = std::min(best, cost);
  }
  Gaps ours;
  for (const TourCost cost : costs) ours.add(cost, best), totals.ours.add(cost, best);
  totals.plain.add(plain, best);
  totals.longest_ms = std::max(totals.longest_ms, ms);
  std::printf("%-14s best %8lld%s  ours mean %.3f %% worst %.3f %%  plain %.2f %%  %.1f ms\n",
              c.name.c_str(), static_cast<long long>(best), known == 0 ? "?" : " ",
              ours.sum / ours.runs, ours.worst,
              100.0 * (static_cast<double>(plain) / static_cast<double>(best) - 1), ms);
}

void print(const char* title, const Totals& totals) {
  std::printf(
      "%s: mean gap %.4f %%, worst %.3f %% of %d runs (nearest neighbour + 2-opt: mean "
      "%.2f %%, worst %.2f %%); longest run %.1f ms\n\n",
      title, totals.ours.sum / std::max(1, totals.ours.runs), totals.ours.worst, totals.ours.runs,
      totals.plain.sum / std::max(1, totals.plain.runs), totals.plain.worst, totals.longest_ms);
}

double cpu_ms_since(std::clock_t begin) {
  return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Without bounds: the same costs both ways, or dearer one way.
void measure_unbounded(bool symmetrical) {
  for (TourCase c : skein::refiners::test::cases_like_tsplib(1, 7)) {
    TourProblem problem = skein::refiners::test::closed_tour(c);
    if (!symmetrical)
      for (std::size_t i = 0; i < problem.gates(); ++i)
        for (std::size_t j = 0; j < i; ++j) problem.between[i * problem.gates() + j] += 1;
    const auto begin = std::clock();
    const auto order = solve_tour(problem, {}, 1);
    const double ms = cpu_ms_since(begin);
    std::printf("%-14s %s, without bounds: %.1f ms CPU, %llu steps\n", c.name.c_str(),
                symmetrical ? "symmetrical" : "general", ms,
                static_cast<unsigned long long>(order.effort.steps));
  }
}

void measure_hills(std::size_t stops, std::uint64_t seed, bool hovers) {
  namespace test = skein::refiners::test;
  const skein::world::World world = test::hills();
  const skein::refiners::TourQuery query = test::tour_among_hills(world, stops, seed, hovers);
  const auto airspace = skein::refiners::airspace_of(test::first_leg(query), {world, {}});
  const test::CountingPlanner planner(*airspace);
  const test::Closed closed = test::closed_pairs(*airspace, query);
  skein::refiners::Setting setting{.world = world, .budget = {}};
  auto begin = std::clock();
  const auto tour = refine(query, setting);
  const double ms = cpu_ms_since(begin);
  setting.paths = &planner;
  const auto counted = refine(query, setting);
  if (!tour || !counted) {
    std::printf("%3zu stops, seed %llu: %s\n", stops, static_cast<unsigned long long>(seed),
                (tour ? counted : tour).error().why.c_str());
    return;
  }
  std::printf(
      "%3zu stops %s seed %llu: %8.1f ms CPU, %5d ways (%.1f a stop) of %zu pairs closed of %zu; "
      "%.0f s%s\n",
      stops, hovers ? "hovering" : "fixed-wing", static_cast<unsigned long long>(seed), ms,
      planner.asked(), planner.asked() / static_cast<double>(stops), closed.closed, closed.pairs,
      tour->cost, tour->task.exact ? ", exact" : "");
}

}  // namespace

int main(int argc, char** argv) {
  const auto time = std::chrono::milliseconds(argc > 1 ? std::atoi(argv[1]) : 50);
  const std::filesystem::path data =
      argc > 2 ? std::filesystem::path(argv[2])
               : std::filesystem::path(__FILE__).parent_path() / "../../../../shared/data/geometry";
  Totals published, made;
  for (const auto& [name, best] : skein::refiners::test::read_optima(data / "tsplib_optima.txt"))
    if (const TourCase c = skein::refiners::test::read_tsplib(data / (name + ".tsp"));
        c.places.size() > 1)
      measure(c, best, time, published);
  print("TSPLIB", published);
  for (const TourCase& c : skein::refiners::test::cases_like_tsplib(3, 7))
    measure(c, 0, time, made);
  print("like TSPLIB, against the best known here", made);
  Totals heaps;
  for (const TourCase& c : skein::refiners::test::cases_of_heaps(4, 7)) measure(c, 0, time, heaps);
  print("heaps far apart, against the best known here", heaps);
  for (const bool symmetrical : {true, false}) measure_unbounded(symmetrical);
  for (const bool hovers : {true, false})
    for (const std::size_t stops : {12, 50, 200})
      for (const std::uint64_t seed : {1, 2, 3}) measure_hills(stops, seed, hovers);
}
