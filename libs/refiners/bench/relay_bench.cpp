// SPDX-License-Identifier: Apache-2.0
// Sight checks of the relay search against those of trying every voxel, in the same run.
#include <chrono>
#include <cstdio>

#include "../test/testing/relay_cases.hpp"

namespace {

using namespace skein;
using namespace skein::refiners;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool hear_each_other(const testing::RelayCase& given) {
  return given.world.radio.margin(given.query.a, given.query.b, given.world.terrain) >=
         given.query.least_margin;
}

void single(std::int32_t across, std::int32_t levels, int count) {
  Random random(7);
  double links = 0, exhaustive = 0, took = 0, took_all = 0;
  int found = 0, wrong = 0;
  for (int i = 0; i < count; ++i) {
    const auto given = testing::random_relay_case(random, across, levels, random.uniform(0.3, 1));
    if (hear_each_other(given)) continue;
    const double start = seconds();
    const auto outcome = refine(given.query, Setting{given.world, {}});
    const double middle = seconds();
    const auto best = testing::best_of_all(given);
    took += middle - start;
    took_all += seconds() - middle;
    if (outcome.has_value() != (best.margin >= 0)) ++wrong;
    if (!outcome) continue;
    if (std::abs(outcome->task.margin - best.margin) > 1e-9) ++wrong;
    ++found;
    links += static_cast<double>(outcome->effort.steps);
    exhaustive += static_cast<double>(best.links);
  }
  std::printf("one relay, %d x %d x %d: %d found, %d unlike exhaustive search\n", across, across,
              levels, found, wrong);
  std::printf("  links %.0f against %.0f: %.0f times fewer; %.2f s against %.2f s\n", links,
              exhaustive, exhaustive / links, took, took_all);
}

void chains(int count) {
  Random random(8);
  int found = 0, none = 0, unlike = 0;
  double took = 0, took_all = 0;
  for (int i = 0; i < count; ++i) {
    auto given = testing::random_relay_case(random, 12, 12, random.uniform(0.15, 0.4));
    given.query.most = 5;
    if (hear_each_other(given)) continue;
    const double start = seconds();
    const auto outcome = refine(given.query, Setting{given.world, {}});
    const double middle = seconds();
    const auto best = testing::bellman_ford(given, 5);
    took += middle - start;
    took_all += seconds() - middle;
    (outcome ? found : none) += 1;
    const bool same = outcome.has_value() == best.has_value() &&
                      (!outcome || (outcome->task.positions.size() == best->relays &&
                                    std::abs(outcome->task.margin - best->margin) < 1e-9));
    if (!same) ++unlike;
  }
  std::printf(
      "chains, 12 x 12 x 12: %d found, %d none, %d unlike Bellman-Ford; %.2f s against %.2f s\n",
      found, none, unlike, took, took_all);
}

void large() {
  Random random(9);
  auto given = testing::random_relay_case(random, 256, 32, 0.3);
  given.query.a = {100, 100, given.world.terrain.elevation(100, 100) + 2};
  given.query.b = {5000, 5000, given.world.terrain.elevation(5000, 5000) + 2};
  given.query.most = 8;
  given.query.least_margin = 0;
  given.query.vehicle.ceiling = 1e4;
  const double start = seconds();
  const auto outcome = refine(given.query, Setting{given.world, {}});
  std::printf("chain, 256 x 256 x 32: %zu relays, %.0f m apart places, %.2f s\n",
              outcome ? outcome->task.positions.size() : 0, outcome ? outcome->task.spacing : 0,
              seconds() - start);
}

}  // namespace

int main() {
  single(16, 16, 200);
  single(64, 16, 30);
  chains(40);
  large();
}
