// SPDX-License-Identifier: Apache-2.0
#include "path/contact_space.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "path/builders.hpp"
#include "path/voxel_worlds.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {
namespace {

using world::Vector3;
using world::World;

bool linked(const World& world, const std::vector<Vector3>& anchors, const Vector3& at) {
  for (const Vector3& anchor : anchors)
    if (world.radio.link(at, anchor, world.terrain, false).up) return true;
  return false;
}

World random_hills(Random& random) {
  std::vector<world::HillSpec> hills;
  for (int i = 0; i < 6; ++i)
    hills.push_back({{random.uniform(0, 600), random.uniform(0, 600)},
                     random.uniform(-20, 120),
                     random.uniform(40, 200)});
  World world = testing::hilly_world(std::move(hills));
  world.radio.range = random.uniform(250, 700);
  return world;
}

Vector3 over_ground(Random& random, const World& world, double height) {
  const double x = random.uniform(20, 580), y = random.uniform(20, 580);
  return {x, y, world.terrain.elevation(x, y) + height};
}

TEST(Anchors, AreTheRelaysWithAChainToTheOther) {
  World world = testing::flat_world();
  world.radio.range = 100;
  const Contact contact{{0, 0, 10}, {{180, 0, 10}, {90, 0, 10}, {300, 0, 10}}};

  EXPECT_THAT(anchors_of(contact, world),
              ::testing::ElementsAre(Vector3(0, 0, 10), Vector3(90, 0, 10), Vector3(180, 0, 10)));
}

TEST(KeepContact, LeavesOnlyVoxelsThatHaveItAtEachPoint) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Random random(seed);
    const World world = random_hills(random);
    const std::vector<Vector3> anchors = {over_ground(random, world, 2),
                                          over_ground(random, world, 40)};
    world::AirspaceSpec spec;
    spec.grid = world.airspace;
    world::Airspace airspace(spec, world.terrain, {});
    keep_contact(airspace, anchors, world);

    for (int i = 0; i < 4000; ++i) {
      const Vector3 at(random.uniform(0, 600), random.uniform(0, 600), random.uniform(0, 200));
      if (!airspace.is_free(at)) continue;
      ASSERT_TRUE(linked(world, anchors, at)) << "seed " << seed;
    }
  }
}

TEST(KeepContact, ClosesOnlyVoxelsThatLackItSomewhere) {
  int closed = 0, doubtful = 0;
  for (std::uint64_t seed = 20; seed < 24; ++seed) {
    Random random(seed);
    const World world = random_hills(random);
    const Vector3 anchor = over_ground(random, world, 3);
    world::AirspaceSpec spec;
    spec.grid = world.airspace;
    const world::Airspace before(spec, world.terrain, {});
    world::Airspace after = before;
    keep_contact(after, {anchor}, world);

    for (int i = 0; i < 400; ++i) {
      const world::Voxel voxel = testing::free_voxel(before, random);
      if (after.is_free(voxel)) continue;
      ++closed;
      bool everywhere = true;
      for (int k = 0; k < 11 * 11 && everywhere; ++k) {
        const Vector3 off((k % 11) / 10.0 - 0.5, k / 11 / 10.0 - 0.5, -0.5);
        everywhere = linked(world, {anchor}, before.centre(voxel) + off * 9.999);
      }
      const Vector3 top = (before.centre(voxel) - anchor).cwiseAbs() + Vector3::Constant(4.9995);
      doubtful += everywhere && top.norm() <= world.radio.range ? 1 : 0;
    }
  }
  EXPECT_GT(closed, 300);
  EXPECT_LE(doubtful, closed / 40) << "links that only points between the samples lack";
}

TEST(ContactPath, HasALinkAtEachSampleAndFailsExactlyWhenTheMaskedGraphDoes) {
  int found = 0, refused = 0;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const World world = random_hills(random);
    PathQuery query =
        testing::query(over_ground(random, world, 30), over_ground(random, world, 30));
    query.contact = Contact{over_ground(random, world, 5), {over_ground(random, world, 60)}};
    const Setting setting{world, {}, 1, nullptr};
    const auto anchors = anchors_of(*query.contact, world);
    const auto airspace = airspace_of(query, setting);
    ASSERT_TRUE(airspace.has_value());
    const auto first = airspace->free_voxel_at(query.from),
               last = airspace->free_voxel_at(query.to);

    const auto outcome = refine(query, setting);

    if (first && last) {
      const bool reachable = testing::PlainDijkstra(*airspace).cost(*first, *last).has_value();
      EXPECT_EQ(outcome.has_value(), reachable);
    }
    if (!outcome) {
      ++refused;
      continue;
    }
    ++found;
    const Way& way = outcome->task.way;
    for (std::size_t i = 1; i < way.size(); ++i)
      for (int k = 0; k <= 400; ++k)
        ASSERT_TRUE(linked(world, anchors, way[i - 1] + (way[i] - way[i - 1]) * k / 400.0));
  }
  EXPECT_GT(found, 3);
  EXPECT_GT(refused, 3);
}

}  // namespace
}  // namespace skein::refiners
