// SPDX-License-Identifier: Apache-2.0
// view points against an exhaustive search: utility found, sight checks, processor time.
// Usage: skein_refiners_viewpoint_bench [cases], at the root of the source tree (for real ground).
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#ifndef SKEIN_SOURCE_DIR
#define SKEIN_SOURCE_DIR "."
#endif
#include "../test/viewpoint/cases.hpp"

namespace {

using namespace skein;  // NOLINT: a program of its own

double cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Figures {
  std::vector<double> share, checks_ratio, own_ms, all_ms;
  std::uint64_t solved = 0, own_checks = 0, all_checks = 0, steps = 0, missed = 0, only_own = 0;
};

double at(std::vector<double> sorted, double part) {
  if (sorted.empty()) return 0;
  std::sort(sorted.begin(), sorted.end());
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

void measure(const refiners::ViewpointCase& c, std::uint64_t seed, Figures& figures) {
  const double begin = cpu();
  const auto found = refiners::refine(c.query, refiners::Setting{c.world, {}, seed, nullptr});
  const double middle = cpu();
  const double phase = Random(seed, "phase").uniform();
  const refiners::Exhaustive all = refiners::search_all(c, phase, false);
  const double end = cpu();
  if (!all.utility) {
    figures.only_own += found ? 1 : 0;
    return;
  }
  ++figures.solved;
  figures.missed += found ? 0 : 1;
  const auto utility = found ? std::optional(found->task.points[0].utility) : std::nullopt;
  figures.share.push_back(refiners::share_found(all, utility));
  if (figures.share.back() < 0.99)
    std::printf("  case %llu: %.4f of %.4f\n", static_cast<unsigned long long>(seed),
                utility.value_or(0), *all.utility);
  figures.own_ms.push_back(1e3 * (middle - begin));
  figures.all_ms.push_back(1e3 * (end - middle));
  if (!found) return;
  const auto own = std::max<std::uint64_t>(found->task.sight_checks, 1);
  figures.checks_ratio.push_back(static_cast<double>(all.sight_checks) / static_cast<double>(own));
  figures.own_checks += own;
  figures.all_checks += all.sight_checks;
  figures.steps += found->effort.steps;
}

void print(const char* title, const Figures& f) {
  const auto n = static_cast<double>(std::max<std::size_t>(f.share.size(), 1));
  const auto good =
      std::count_if(f.share.begin(), f.share.end(), [](double s) { return s >= 0.99; });
  std::printf("%s: %llu cases with an answer (%llu missed by us, %llu found by us alone)\n", title,
              static_cast<unsigned long long>(f.solved), static_cast<unsigned long long>(f.missed),
              static_cast<unsigned long long>(f.only_own));
  std::printf(
      "  utility of exhaustive: min %.4f, 1 %% %.4f, 5 %% %.4f, median %.4f; >= 0.99 in %.2f %%\n",
      at(f.share, 0), at(f.share, 0.01), at(f.share, 0.05), at(f.share, 0.5),
      100.0 * static_cast<double>(good) / n);
  const auto few =
      std::count_if(f.checks_ratio.begin(), f.checks_ratio.end(), [](double r) { return r < 20; });
  std::printf(
      "  sight checks, exhaustive / ours: min %.1f, 5 %% %.1f, median %.1f (all: %.1f); "
      "below 20 in %ld cases\n",
      at(f.checks_ratio, 0), at(f.checks_ratio, 0.05), at(f.checks_ratio, 0.5),
      static_cast<double>(f.all_checks) /
          static_cast<double>(std::max<std::uint64_t>(f.own_checks, 1)),
      static_cast<long>(few));
  std::printf(
      "  ours per call: %.0f checks, %.0f places; CPU median %.2f ms, 95 %% %.2f, max %.2f; "
      "exhaustive median %.1f ms\n",
      static_cast<double>(f.own_checks) / n, static_cast<double>(f.steps) / n, at(f.own_ms, 0.5),
      at(f.own_ms, 0.95), at(f.own_ms, 1), at(f.all_ms, 0.5));
}

}  // namespace

int main(int argc, char** argv) {
  const auto cases = static_cast<std::uint64_t>(argc > 1 ? std::atoi(argv[1]) : 500);
  Figures hills, real;
  for (std::uint64_t seed = 1; seed <= cases; ++seed) {
    Random random(seed, "ground");
    measure(refiners::random_case(seed, refiners::random_hills(random), 1), seed, hills);
  }
  print("hills", hills);
  if (const auto ground = refiners::jacksboro(90)) {
    for (std::uint64_t seed = 1; seed <= std::max<std::uint64_t>(cases / 5, 1); ++seed)
      measure(refiners::random_case(seed, *ground, 5), seed, real);
    print("jacksboro", real);
  }
  return 0;
}
