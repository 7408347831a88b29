// SPDX-License-Identifier: Apache-2.0
// coverage: mission time against a brute force over every degree with the same turn model, against
// a sweep of the convex hull, and CPU time per call.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>

#include "../test/testing/builders.hpp"
#include "../test/testing/coverage_cases.hpp"

namespace skein::refiners::testing {
namespace {

double cpu_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

struct Figures {
  std::vector<double> all;

  void add(double figure) { all.push_back(figure); }
  double mean() const {
    double sum = 0;
    for (const double figure : all) sum += figure;
    return sum / static_cast<double>(all.size());
  }
  double worst() const { return *std::max_element(all.begin(), all.end()); }
  double median() const {
    std::vector<double> sorted = all;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

double cost_or_exit(const CoverageQuery& query, const Setting& setting) {
  const auto outcome = refine(query, setting);
  if (outcome) return outcome->cost;
  std::fprintf(stderr, "refused: %s: %s\n", outcome.error().field.c_str(),
               outcome.error().why.c_str());
  std::exit(1);
}

double best_of_every_degree(CoverageQuery query, const Setting& setting) {
  query.mode = SweepMode::kGiven;
  double least = 1e300;
  for (int degree = 0; degree < 180; ++degree) {
    query.direction = degree * std::numbers::pi / 180;
    least = std::min(least, cost_or_exit(query, setting));
  }
  return least;
}

struct Campaign {
  const char* name;
  world::VehicleModel vehicle;
  std::function<void(Random&, CoverageQuery&)> shape;
  int cases;
  bool against_hull;
};

void run(const Campaign& campaign, const Setting& setting) {
  Random random(11, campaign.name);
  Figures ratio, milliseconds, covered_part;
  for (int i = 0; i < campaign.cases; ++i) {
    CoverageQuery query;
    query.vehicle = campaign.vehicle;
    query.vehicle.energy.capacity = 1e12;
    campaign.shape(random, query);
    query.swath = random.uniform(20, 90);
    query.altitude = 60;
    if (random.chance(0.5))
      query.start = Vector3(random.uniform(-800, 800), random.uniform(-800, 800), 60);
    if (random.chance(0.3))
      query.end = Vector3(random.uniform(-800, 800), random.uniform(-800, 800), 60);
    const double before = cpu_milliseconds();
    const auto outcome = refine(query, setting);
    milliseconds.add(cpu_milliseconds() - before);
    if (!outcome) std::exit(1);
    CoverageQuery baseline = query;
    if (campaign.against_hull) {
      baseline.area = wrapped_hull(query.area);
      baseline.holes.clear();
    }
    ratio.add(outcome->cost / best_of_every_degree(baseline, setting));
    covered_part.add(1 - covered(query, outcome->task, 4000));
  }
  std::printf(
      "%-34s n=%d  time ratio mean %.4f median %.4f worst %.4f  CPU ms median %.3f worst %.3f  "
      "uncovered worst %.5f\n",
      campaign.name, campaign.cases, ratio.mean(), ratio.median(), ratio.worst(),
      milliseconds.median(), milliseconds.worst(), covered_part.worst());
}

}  // namespace
}  // namespace skein::refiners::testing

int main() {
  using namespace skein::refiners::testing;
  using skein::Random;
  using skein::refiners::CoverageQuery;
  const skein::world::World world = level_world();
  const skein::refiners::Setting setting{world, {}, 1, nullptr};
  const auto convex = [](Random& random, CoverageQuery& query) {
    query.area = random_convex(random);
  };
  const auto star = [](Random& random, CoverageQuery& query) {
    query.area = random_star(random, 5 + random.below(12));
  };
  const auto star_with_hole = [](Random& random, CoverageQuery& query) {
    query.area = random_star(random, 5 + random.below(12), 250, 500);
    query.holes = {random_star(random, 3 + random.below(5), 50, 120)};
  };
  std::printf("time ratio: mission time / best of a brute force over every degree\n");
  run({"convex, hovers", helicopter(), convex, 400, false}, setting);
  run({"convex, cannot hover", fixed_wing(), convex, 400, false}, setting);
  run({"concave, hovers", helicopter(), star, 100, false}, setting);
  run({"concave, cannot hover", fixed_wing(), star, 100, false}, setting);
  std::printf("time ratio: mission time / the same brute force over the convex hull\n");
  run({"concave, hovers", helicopter(), star, 100, true}, setting);
  run({"concave, cannot hover", fixed_wing(), star, 100, true}, setting);
  run({"concave with a hole, hovers", helicopter(), star_with_hole, 100, true}, setting);
  run({"concave with a hole, cannot hover", fixed_wing(), star_with_hole, 100, true}, setting);
  return 0;
}
