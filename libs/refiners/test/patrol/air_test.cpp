// SPDX-License-Identifier: Apache-2.0
// Patrols beside closed air: whatever the volumes, an answer that can be flown or a refusal.
#include <gtest/gtest.h>

#include <cmath>

#include "skein/foundation/random.hpp"
#include "skein/refiners/flyable.hpp"
#include "skein/refiners/patrol.hpp"
#include "test_cases.hpp"
#include "testing/builders.hpp"

namespace skein::refiners {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): builders read as words
using world::Polygon;
using world::Vector2;

/// A box of random place and sides, turned by a random angle.
Polygon random_box(Random& random, double extent, double least, double most) {
  const Vector2 centre(random.uniform(0, extent), random.uniform(0, extent));
  const double width = random.uniform(least, most), height = random.uniform(least, most);
  const double angle = random.uniform(0, 1.5);
  const Vector2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
  return {centre - width / 2 * along - height / 2 * across,
          centre + width / 2 * along - height / 2 * across,
          centre + width / 2 * along + height / 2 * across,
          centre - width / 2 * along + height / 2 * across};
}

struct Case {
  world::World world = level_world(1000, 200);
  PatrolQuery query;
};

/// A zone, a start beside it, up to five volumes; one in two vehicles cannot hover.
Case a_case(std::uint64_t seed) {
  Random random(seed, "patrol-air");
  Case made;
  made.query.zone = random_box(random, 300, 40, 320);
  made.query.vehicle = random.chance(0.5) ? helicopter() : fixed_wing();
  made.query.vehicle.energy.capacity = 1e12;
  made.query.vehicle.min_turn_radius *= random.uniform(0.3, 1);
  made.query.start = {random.uniform(-150, 450), random.uniform(-150, 450), 60};
  made.query.heading = random.uniform(-3, 3);
  made.query.altitude = 60;
  made.query.footprint = random.uniform(8, 60);
  made.query.duration = Duration::seconds(random.uniform(5, 400));
  const int volumes = static_cast<int>(random.uniform(1, 6));
  for (int i = 0; i < volumes; ++i) {
    world::Volume volume;
    volume.name = "closed";
    volume.polygon = random_box(random, 300, 20, 220);
    made.world.volumes.push_back(std::move(volume));
  }
  made.world.ground.grid = {.west = -250, .south = -250, .cell = 10, .columns = 80, .rows = 80};
  return made;
}

void expect_outside(const Way& way, const std::vector<world::Volume>& volumes,
                    const std::string& which) {
  for (std::size_t i = 1; i < way.size(); ++i)
    for (double t = 0; t <= 1; t += 0.05)
      for (const world::Volume& volume : volumes)
        ASSERT_FALSE(
            world::contains(volume.polygon, (way[i - 1] + t * (way[i] - way[i - 1])).head<2>()))
            << which << ", leg " << i;
}

TEST(PatrolBesideClosedAir, IsFlownOutsideItAllItsTimeOrRefused) {
  int answered = 0, turning = 0;
  const std::uint64_t cases = skein::testing::cases(60U, 400U);
  for (std::uint64_t seed = 1; seed <= cases; ++seed) {
    const Case one = a_case(seed);
    const std::string which = "seed " + std::to_string(seed);

    const auto refined = refine(one.query, Setting{.world = one.world, .budget = {}});

    if (!refined) {
      EXPECT_NE(refined.error().kind, RefusalKind::kBudgetExhausted) << which;
      continue;
    }
    ++answered;
    if (!one.query.vehicle.hovers) ++turning;
    const Way& way = refined->task.way;
    EXPECT_EQ(way.front(), one.query.start) << which;
    expect_outside(way, one.world.volumes, which);
    EXPECT_TRUE(is_flyable(way, one.query.vehicle, 0, 0.5)) << which;
    EXPECT_GT(refined->task.predicted.cells, 0U) << which;
    const double left = one.query.duration.to_seconds() - refined->duration.expected.to_seconds();
    const double chord = one.query.vehicle.min_turn_radius / one.query.vehicle.cruise_speed + 1e-3;
    EXPECT_LE(left, chord) << which;
  }
  EXPECT_GE(answered, static_cast<int>(cases) / 3);
  EXPECT_GE(turning, static_cast<int>(cases) / 8);
}

// A dead end between two volumes: the only way out of it is the way in.
TEST(PatrolBesideClosedAir, OfADeadEndComesBackOutOfIt) {
  Case one = a_case(1);
  one.query.vehicle = helicopter();
  one.query.vehicle.energy.capacity = 1e12;
  one.query.zone = {{0, 0}, {200, 0}, {200, 60}, {60, 60}, {60, 200}, {0, 200}};
  one.query.start = {10, 10, 60};
  one.query.footprint = 12;
  one.query.duration = Duration::seconds(300);
  one.world.volumes[0].polygon = {{30, 70}, {80, 70}, {80, 210}, {30, 210}};
  one.world.volumes.resize(1);

  const auto refined = refine(one.query, Setting{.world = one.world, .budget = {}});

  ASSERT_TRUE(refined) << refined.error().why;
  EXPECT_EQ(refined->task.predicted.unseen, 0U);
  expect_outside(refined->task.way, one.world.volumes, "dead end");
  EXPECT_NEAR(refined->duration.expected.to_seconds(), 300, 1e-3);
}

}  // namespace
}  // namespace skein::refiners
