// SPDX-License-Identifier: Apache-2.0
// The ways through random voxels, judged by FCL on the voxels themselves.
#include "voxel_boxes.hpp"

#include <gtest/gtest.h>

#include "path/voxel_worlds.hpp"
#include "skein/refiners/voxel_path_planner.hpp"
#include "test_cases.hpp"

namespace skein::sampling {
namespace {

using refiners::testing::cube;
using refiners::testing::free_voxel;
using refiners::testing::random_world;
using world::Airspace;
using world::Vector3;

/// From sparse to mazes; with and without boxes and dear voxels.
refiners::testing::Mixture mixture_of(Random& random) {
  refiners::testing::Mixture mixture;
  mixture.blocked = random.uniform(0, 0.5);
  mixture.boxes = static_cast<int>(random.below(20));
  mixture.dear = random.chance(0.5) ? 0 : 0.3;
  return mixture;
}

TEST(VoxelBoxes, AreMetWhereTheAirIsBlockedAndNowhereElse) {
  Airspace airspace(cube(4));
  std::vector<std::uint8_t> voxels = airspace.voxels();
  voxels[airspace.grid().index(1, 1, 1)] = Airspace::kBlocked;
  airspace = Airspace(airspace.grid(), voxels);
  const VoxelBoxes boxes(airspace);

  EXPECT_TRUE(boxes.meets({{0.5, 1.5, 1.5}, {3.5, 1.5, 1.5}})) << "through the middle";
  EXPECT_TRUE(boxes.meets({{0, 1.001, 1.001}, {4, 1.001, 1.001}})) << "inside an edge";
  EXPECT_TRUE(boxes.meets({{0.5, 1.51, 1.01}, {1.51, 0.5, 1.01}})) << "across a corner";
  EXPECT_FALSE(boxes.meets({{0, 1, 1}, {4, 1, 1}})) << "along an edge";
  EXPECT_FALSE(boxes.meets({{0.5, 1.5, 2}, {3.5, 1.5, 2}})) << "along a face";
  EXPECT_TRUE(boxes.meets({{0.5, 0.5, 0.5}, {4.5, 0.5, 0.5}})) << "out of the grid";
}

TEST(VoxelWays, NeverMeetABlockedVoxelByFcl) {
  Random random(11);
  int found = 0;
  const int count = skein::testing::cases(40, 500);
  for (int i = 0; i < count; ++i) {
    const Airspace airspace = random_world(random, cube(24), mixture_of(random));
    const Vector3 from = airspace.centre(free_voxel(airspace, random));
    const Vector3 to = airspace.centre(free_voxel(airspace, random));

    const auto found_way = refiners::find_way(airspace, from, to, refiners::Budget());

    if (!found_way.found || from == to) continue;
    ++found;
    const VoxelBoxes boxes(airspace);
    EXPECT_FALSE(boxes.meets(found_way.way)) << "world " << i;
    EXPECT_FALSE(boxes.meets(found_way.graph_way)) << "world " << i;
  }
  EXPECT_GE(found, count / 2);
}

}  // namespace
}  // namespace skein::sampling
