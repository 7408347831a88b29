// SPDX-License-Identifier: Apache-2.0
// View points against an exhaustive search on a lattice four times finer along each axis.
#include <gtest/gtest.h>

#include <cstdio>

#include "test_cases.hpp"
#include "viewpoint/cases.hpp"

namespace skein::refiners {
namespace {

using world::Vector3;

/// Few cases in a test run, all of them on request.
std::uint64_t cases(std::uint64_t few, std::uint64_t all) {
  return skein::testing::cases(few, all);
}

/// By the ground at many points in between, not by the exact intersection the service relies on.
bool sees_by_sampling(const world::Terrain& terrain, const Vector3& place, const Vector3& target) {
  constexpr int samples = 3000;
  for (int i = 0; i <= samples; ++i) {
    const Vector3 at = place + (target - place) * i / samples;
    if (at.z() < terrain.elevation(at.x(), at.y()) - 0.011) return false;
  }
  return true;
}

struct Tally {
  std::uint64_t solved = 0, good = 0, own_checks = 0, all_checks = 0;
  double least_ratio = 1e9;
};

void compare(const ViewpointCase& c, std::uint64_t seed, Tally& tally) {
  const auto found = refine(c.query, Setting{c.world, {}, seed, nullptr});
  const Exhaustive all = search_all(c, Random(seed, "phase").uniform(), true);
  if (found) {
    const ViewPoint& best = found->task.points[0];
    EXPECT_TRUE(will_do(c, best.position)) << seed;
    EXPECT_TRUE(sees_by_sampling(c.world.terrain, best.position, c.query.target)) << seed;
    const Vector3 normal = ground_normal(c.world.terrain, c.query.target);
    EXPECT_NEAR(best.utility, utility_of(c, best.position, normal), 1e-9) << seed;
  }
  if (!all.utility) return;
  const auto utility = found ? std::optional(found->task.points[0].utility) : std::nullopt;
  ++tally.solved;
  tally.good += share_found(all, utility) >= 0.99 ? 1 : 0;
  if (!found) return;
  tally.own_checks += found->task.sight_checks;
  tally.all_checks += all.sight_checks;
  tally.least_ratio =
      std::min(tally.least_ratio, static_cast<double>(all.sight_checks) /
                                      static_cast<double>(found->task.sight_checks));
}

void expect_goal(const Tally& tally) {
  std::printf(
      "  %llu cases with an answer, %llu at 0.99 or more; sight checks: %.0f times fewer, "
      "at least %.1f\n",
      static_cast<unsigned long long>(tally.solved), static_cast<unsigned long long>(tally.good),
      static_cast<double>(tally.all_checks) / static_cast<double>(tally.own_checks),
      tally.least_ratio);
  EXPECT_GE(tally.good * 100, tally.solved * 95);
  EXPECT_GE(tally.all_checks, 20 * tally.own_checks);
  EXPECT_GE(tally.least_ratio, 20) << "in each single case, which is more than the goal";
}

TEST(ViewpointSearch, FindsWhatAnExhaustiveSearchFindsOverHills) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= cases(12, 500); ++seed) {
    Random random(seed, "ground");
    compare(random_case(seed, random_hills(random), 1), seed, tally);
  }

  expect_goal(tally);
}

TEST(ViewpointSearch, FindsWhatAnExhaustiveSearchFindsOverRealGround) {
  const auto ground = jacksboro(90);
  if (!ground) GTEST_SKIP() << "jacksboro.asc is not there";
  Tally tally;
  for (std::uint64_t seed = 1; seed <= cases(6, 100); ++seed)
    compare(random_case(seed, *ground, 5), seed, tally);

  expect_goal(tally);
}

TEST(ViewpointSearch, TheSecondIsTheBestThatIsApartFromTheFirst) {
  std::uint64_t solved = 0, good = 0;
  for (std::uint64_t seed = 1; seed <= cases(6, 200); ++seed) {
    Random random(seed, "ground");
    ViewpointCase c = random_case(seed, random_hills(random), 1);
    c.query.count = 2;
    c.query.least_angle = random.uniform(0.3, 1.2);
    const auto found = refine(c.query, Setting{c.world, {}, seed, nullptr});
    if (!found || found->task.points.size() < 2) continue;

    const ViewPoint first = found->task.points[0];
    const double least = c.query.least_angle, range = c.query.vehicle.sensors[0].range;
    c.query.constraints.push_back({"apart", [&, target = c.query.target](const Vector3& place) {
                                     const Vector3 offset = target - place;
                                     const double heading = std::atan2(offset.y(), offset.x());
                                     return std::abs(world::wrapped(heading - first.heading)) >=
                                                least &&
                                            (place - first.position).norm() >= kLeastApart * range;
                                   }});
    const Exhaustive all = search_all(c, Random(seed, "phase").uniform(), true);

    ++solved;
    good += share_found(all, found->task.points[1].utility) >= 0.99 ? 1 : 0;
  }
  std::printf("  %llu of %llu\n", static_cast<unsigned long long>(good),
              static_cast<unsigned long long>(solved));
  EXPECT_GE(good * 100, solved * 95);
  EXPECT_GT(solved, 3u);
}

TEST(ViewpointSearch, SeveralAreAllGoodApartAndBestFirst) {
  const std::uint64_t all = cases(8, 500);
  std::uint64_t several = 0;
  for (std::uint64_t seed = 1; seed <= all; ++seed) {
    Random random(seed, "ground");
    ViewpointCase c = random_case(seed, random_hills(random), 1);
    c.query.count = 2 + random.below(4);
    c.query.least_angle = random.chance(0.3) ? 0 : random.uniform(0.2, 2.5);

    const auto found = refine(c.query, Setting{c.world, {}, seed, nullptr});

    if (!found) continue;
    const auto& points = found->task.points;
    EXPECT_LE(points.size(), c.query.count);
    several += points.size() > 1 ? 1 : 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_TRUE(will_do(c, points[i].position)) << seed;
      EXPECT_LE(points[i].utility, points[i > 0 ? i - 1 : 0].utility);
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE((points[i].position - points[j].position).norm(),
                  kLeastApart * c.query.vehicle.sensors[0].range * (1 - 1e-6));
        EXPECT_GE(std::abs(world::wrapped(points[i].heading - points[j].heading)),
                  c.query.least_angle - 1e-6)
            << seed;
      }
    }
  }
  EXPECT_GT(3 * several, all);
}

}  // namespace
}  // namespace skein::refiners
