// SPDX-License-Identifier: Apache-2.0
#include "skein/world/object.hpp"

#include <gtest/gtest.h>

namespace skein::world {
namespace {

Terrain terrain_with_hill() {
  TerrainSpec spec;
  spec.west = spec.south = -200;
  spec.east = spec.north = 200;
  spec.hills = {{{100, 0}, 30, 80}};
  return Terrain(spec);
}

WorldObject truck() {
  WorldObject object;
  object.name = "truck";
  object.kind = "hot-vehicle";
  object.height = 1;
  object.appears = MissionTime::seconds(10);
  object.waypoints = {{100, 0}, {100, 50}};
  object.speed = 5;
  return object;
}

Vector2 place(const WorldObject& object, double seconds) {
  return position_at(object, MissionTime::seconds(seconds), terrain_with_hill()).head<2>();
}

TEST(WorldObject, IsActiveFromItsAppearanceUntilItsDisappearance) {
  WorldObject object = truck();
  object.disappears = MissionTime::seconds(20);

  EXPECT_FALSE(is_active(object, MissionTime::seconds(9.999)));
  EXPECT_TRUE(is_active(object, MissionTime::seconds(10)));
  EXPECT_TRUE(is_active(object, MissionTime::seconds(19.999)));
  EXPECT_FALSE(is_active(object, MissionTime::seconds(20)));
}

TEST(WorldObject, MovesAlongItsWayFromItsAppearanceAndStopsAtItsEnd) {
  EXPECT_EQ(place(truck(), 0), Vector2(0, 0));
  EXPECT_EQ(place(truck(), 10), Vector2(0, 0));
  EXPECT_EQ(place(truck(), 20), Vector2(50, 0));
  EXPECT_EQ(place(truck(), 35), Vector2(100, 25));
  EXPECT_EQ(place(truck(), 1000), Vector2(100, 50));
}

TEST(WorldObject, WithoutWayOrSpeedItStays) {
  WorldObject no_way = truck(), no_speed = truck();
  no_way.waypoints.clear();
  no_speed.speed = 0;

  EXPECT_EQ(place(no_way, 100), Vector2(0, 0));
  EXPECT_EQ(place(no_speed, 100), Vector2(0, 0));
}

TEST(WorldObject, LegsOfNoLengthDoNoHarm) {
  WorldObject object = truck();
  object.waypoints = {{0, 0}, {0, 0}, {10, 0}};

  EXPECT_EQ(place(object, 11), Vector2(5, 0));
}

TEST(WorldObject, FollowsTheGround) {
  const Terrain terrain = terrain_with_hill();
  const Vector3 on_top = position_at(truck(), MissionTime::seconds(30), terrain);

  EXPECT_NEAR(on_top.z(), terrain.elevation(100, 0) + 1, 1e-9);
}

}  // namespace
}  // namespace skein::world
