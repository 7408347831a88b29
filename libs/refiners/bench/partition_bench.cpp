// SPDX-License-Identifier: Apache-2.0
// How evenly balanced shares finish, against shares in proportion in the same run; and what
// dividing costs.
#include <chrono>
#include <cstdio>

#include "../test/testing/partition_cases.hpp"

namespace {

using namespace skein;
using namespace skein::refiners;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double quantile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

void balance(const char* name, double larger, int count) {
  Random random(2026);
  const world::World world = testing::level_world(5000);
  std::vector<double> before, after, ratio, took;
  for (int i = 0; i < count; ++i) {
    PartitionQuery query = testing::three_unlike(random, larger);
    const auto proportional = refine(query, Setting{world, {}});
    query.mode = ShareMode::kBalanced;
    const double start = seconds();
    const auto balanced = refine(query, Setting{world, {}});
    took.push_back(1e3 * (seconds() - start));
    if (!proportional || !balanced) continue;
    before.push_back(proportional->task.spread);
    after.push_back(balanced->task.spread);
    ratio.push_back(balanced->cost / proportional->cost);
  }
  std::printf("%s: %zu of %d answered\n", name, after.size(), count);
  std::printf("  spread, in proportion: median %.3f, worst %.3f\n", quantile(before, 0.5),
              quantile(before, 1));
  std::printf("  spread, balanced:      median %.3f (goal 0.05), 90%% %.3f, worst %.3f\n",
              quantile(after, 0.5), quantile(after, 0.9), quantile(after, 1));
  std::printf("  latest finish, balanced / in proportion: median %.3f (goal 0.92), worst %.3f\n",
              quantile(ratio, 0.5), quantile(ratio, 1));
  std::printf("  wall time of balancing: median %.0f ms, worst %.0f ms\n", quantile(took, 0.5),
              quantile(took, 1));
}

void divisions(const char* name, double span, bool inside, int count) {
  Random random(1);
  std::vector<double> took;
  for (int i = 0; i < count; ++i) {
    const world::Polygon area =
        testing::random_convex(random, random.uniform(50, 2000), 3 + random.below(12));
    std::vector<world::Vector2> anchors;
    std::vector<double> shares;
    for (std::size_t k = 1 + random.below(12); k > 0; --k) {
      anchors.push_back(inside ? testing::within(random, area) : testing::on_border(random, area));
      shares.push_back(std::pow(span, -random.uniform()));
    }
    const double start = seconds();
    divide(area, anchors, shares);
    took.push_back(1e3 * (seconds() - start));
  }
  std::printf("divide, up to 12 parts, %s: median %.2f ms, 99%% %.2f ms, worst %.1f ms\n", name,
              quantile(took, 0.5), quantile(took, 0.99), quantile(took, 1));
}

}  // namespace

int main() {
  divisions("anchors on the border", 5, false, 1000);
  divisions("anchors on the border, shares 1:1000", 1000, false, 1000);
  divisions("anchors inside", 5, true, 1000);
  balance("200 areas of 150 to 500 m radius, starts anywhere around", 1, 200);
  balance("200 areas of 450 to 1500 m radius", 3, 200);
}
