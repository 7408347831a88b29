// SPDX-License-Identifier: Apache-2.0
// Places to get out of the way to.
#include "merging/airways.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/merged_team.hpp"

namespace skein::decision_node {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Over ground of that elevation, all around it to its height and above taken.
std::vector<double> heights_aside(double elevation) {
  world::TerrainSpec ground;
  ground.west = ground.south = -1'000;
  ground.east = ground.north = 1'000;
  ground.base = elevation;
  MergingConfig config;
  config.model = testing::quick_helicopter();
  config.terrain = std::make_shared<const world::Terrain>(ground);
  AirwaySituation situation;
  situation.state.position = {0, 0, 40};
  situation.state.airborne = true;
  situation.rest = situation.state.position;
  const merging::Volume taken{{-10'000, 0}, {10'000, 0}, 10'000, 38, 500};
  std::vector<double> heights;
  for (const Airway& one : ways_aside(functional::TaskId(1), {taken}, config, situation))
    heights.push_back(one.end->z());
  return heights;
}

// Found by random missions (--crossing 610510): others flew over it and around it.
TEST(WaysAside, LeadDownWhereThereIsNoOtherAir) { EXPECT_THAT(heights_aside(0), Contains(16)); }

TEST(WaysAside, DoNotLeadDownToTheGround) {
  EXPECT_THAT(heights_aside(12), ElementsAre(28)) << "but to 16 m over it";
  EXPECT_THAT(heights_aside(30), IsEmpty());
}

}  // namespace
}  // namespace skein::decision_node
