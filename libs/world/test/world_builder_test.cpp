// SPDX-License-Identifier: Apache-2.0
#include "skein/world/world_builder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace skein::world {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

WorldFile hills() {
  WorldFile file;
  file.file = "w.yaml";
  file.origin = {37, -6, 100};
  file.terrain = TerrainSpec{-500, -400, 500, 600, 20, 10, {{{0, 0}, 90, 200}}, {}};
  return file;
}

World built(WorldFile file) {
  auto world = build_world(std::move(file));
  if (!world) ADD_FAILURE() << to_text(world.error());
  return std::move(world.value());
}

std::string report(WorldFile file) {
  const auto world = build_world(std::move(file));
  return world ? "" : to_text(world.error());
}

TEST(WorldBuilder, TakesOverWhatTheFileSays) {
  WorldFile file = hills();
  file.wind = {1, 2, 3};
  file.volumes = {{"v", {{0, 0}, {1, 0}, {1, 1}}, 0, 10, {}}};
  file.zones = {{"z", {{0, 0}, {1, 0}, {1, 1}}}};
  file.places["p"] = {Vector3(1, 2, 3), {}};

  const World world = built(file);

  EXPECT_EQ(world.origin, (GeodeticOrigin{37, -6, 100}));
  EXPECT_NEAR(world.terrain.elevation(0, 0), 100, 1e-9);
  EXPECT_EQ(world.wind, (Wind{1, 2, 3}));
  EXPECT_EQ(world.volumes, file.volumes);
  EXPECT_THAT(world.zones, SizeIs(1));
  EXPECT_EQ(world.places.at("p"), Vector3(1, 2, 3));
}

TEST(WorldBuilder, AirspaceFollowsFromTheGround) {
  const AirspaceGrid air = built(hills()).airspace;

  EXPECT_EQ(air.origin, Vector3(-500, -400, 10));
  EXPECT_GE(air.size[0] * air.voxel, 1000);
  EXPECT_GE(air.size[1] * air.voxel, 1000);
  EXPECT_GE(air.size[2] * air.voxel, 390) << "300 m over the highest ground";
  EXPECT_LE(air.count(), kDefaultVoxels);
  AirspaceGrid finer = air;
  finer.voxel -= 1;
  EXPECT_GT(1000 / finer.voxel * 1000 / finer.voxel * 390 / finer.voxel, kDefaultVoxels)
      << "no coarser than needed";
}

RC_GTEST_PROP(WorldBuilder, AirspaceWithoutAVoxelSizeHasAtMostEightMillion, ()) {
  WorldFile file = hills();
  auto& terrain = std::get<TerrainSpec>(file.terrain);
  terrain.east = terrain.west + *rc::gen::inRange(1, 100'000);
  terrain.north = terrain.south + *rc::gen::inRange(1, 100'000);
  terrain.cell = 500;

  const AirspaceGrid air = built(file).airspace;

  RC_ASSERT(air.count() <= kDefaultVoxels);
  RC_ASSERT(air.size[0] * air.voxel >= terrain.east - terrain.west);
  RC_ASSERT(air.size[1] * air.voxel >= terrain.north - terrain.south);
}

TEST(WorldBuilder, AirspaceIsWhatWasAskedFor) {
  WorldFile file = hills();
  file.airspace = {-100, -50, 205, 50, 0, 95, 10, {}};

  const AirspaceGrid air = built(file).airspace;

  EXPECT_EQ(air.origin, Vector3(-100, -50, 0));
  EXPECT_EQ(air.size, (std::array<std::int32_t, 3>{31, 10, 10}));
}

TEST(WorldBuilder, AirspaceWithoutExtentOrOfTooManyVoxelsIsRefused) {
  WorldFile below = hills();
  below.airspace.ceiling = 5;
  below.airspace.mark = {7, "airspace"};
  WorldFile fine = hills();
  fine.airspace.voxel = 0.1;
  fine.airspace.mark = {7, "airspace"};

  EXPECT_THAT(report(below), HasSubstr("w.yaml:7: airspace: the airspace has no extent"));
  EXPECT_THAT(report(fine), HasSubstr("w.yaml:7: airspace: "));
}

TEST(WorldBuilder, GroundCellsCoverTheTerrain) {
  WorldFile file = hills();
  file.ground.cell = 30;

  const Grid grid = built(file).ground.grid;

  EXPECT_EQ(grid, (Grid{-500, -400, 30, 34, 34}));
}

TEST(WorldBuilder, RiskIsTheSameEverywhereOrHighestAtItsPeaks) {
  WorldFile file = hills();
  EXPECT_EQ(built(file).ground.risk_at({0, 0}), 0.5) << "when nothing is said";
  file.ground.risk = 0.2;
  EXPECT_EQ(built(file).ground.risk_at({0, 0}), 0.2);

  file.ground.cell = 10;
  file.ground.risk = RiskPeaks{0.1, {{{5, 5}, 0.9, 100}, {{55, 5}, 0.3, 400}}};
  const GroundState ground = built(file).ground;

  EXPECT_NEAR(ground.risk_at({5, 5}), 0.9, 1e-12) << "the middle of a cell";
  EXPECT_NEAR(ground.risk_at({-450, 5}), 0.1, 1e-12) << "beyond both";
  EXPECT_NEAR(ground.risk_at({5, 205}),
              0.1 + 0.2 * (1 + std::cos(std::numbers::pi * std::hypot(50, 200) / 400)) / 2, 1e-12)
      << "beyond the first";
}

RC_GTEST_PROP(WorldBuilder, RiskStaysBetweenBaseAndPeaks, ()) {
  WorldFile file = hills();
  RiskPeaks peaks{*rc::gen::inRange(0, 100) / 100.0, {}};
  double highest = peaks.base;
  for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
    const double risk = *rc::gen::inRange(0, 101) / 100.0;
    peaks.peaks.push_back({{*rc::gen::inRange(-700, 700) * 1.0, *rc::gen::inRange(-700, 700) * 1.0},
                           risk,
                           *rc::gen::inRange(1, 900) * 1.0});
    highest = std::max(highest, risk);
  }
  file.ground.risk = peaks;

  for (const double risk : built(file).ground.risk) {
    RC_ASSERT(risk >= peaks.base);
    RC_ASSERT(risk <= highest + 1e-12);
  }
}

TEST(WorldBuilder, AlarmsAndFiresAreInTheirCells) {
  WorldFile file = hills();
  file.ground.alarms = {{-480, -380}, {10, 10}};
  file.ground.fires = {{10, 10}};

  const GroundState ground = built(file).ground;

  EXPECT_EQ(ground.state[*ground.grid.at({-480, -380})], CellState::kAlarm);
  EXPECT_EQ(ground.state[*ground.grid.at({10, 10})], CellState::kFire) << "a fire counts more";
  EXPECT_EQ(ground.state[*ground.grid.at({400, 400})], CellState::kQuiet);
  EXPECT_THAT(built(hills()).ground.state, IsEmpty());
}

TEST(WorldBuilder, AFireOffTheGroundIsRefused) {
  WorldFile file = hills();
  file.ground.fires = {{5000, 0}};
  file.ground.mark = {9, "ground"};

  EXPECT_THAT(report(file), HasSubstr("w.yaml:9: ground: "));
  EXPECT_THAT(report(file), HasSubstr("is off the ground"));
}

RC_GTEST_PROP(WorldBuilder, MappedCellsAreThoseWhoseMiddleIsInAPolygon, ()) {
  WorldFile file = hills();
  for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
    // No edge goes through the middle of a cell, where rounding decides.
    const auto at = [] {
      return Vector2(*rc::gen::inRange(-60, 60) * 10 + std::numbers::sqrt2,
                     *rc::gen::inRange(-60, 60) * 10 + std::numbers::sqrt3);
    };
    const Vector2 a = at(), b = at(), c = at();
    file.ground.mapped.push_back({a, b, c});
  }
  const GroundState ground = built(file).ground;

  for (std::size_t i = 0; i < ground.grid.size(); ++i) {
    bool inside = false;
    for (const Polygon& polygon : file.ground.mapped)
      inside = inside || contains(polygon, ground.grid.centre(i));
    RC_ASSERT(ground.mapped[i] == inside);
  }
}

TEST(WorldBuilder, MoreGroundThanMemoryAllowsIsRefused) {
  WorldFile file = hills();
  file.ground.cell = 0.1;
  file.ground.risk = 0.2;

  EXPECT_THAT(report(file), HasSubstr("more than 4 million cells of ground"));
}

TEST(WorldBuilder, WhatOnlyGeodataFindsMustBeFoundBefore) {
  WorldFile raster = hills();
  raster.terrain = RasterTerrain{{"dem.tif", "", {}, {3, "terrain.raster"}}, {}, {}};
  WorldFile risk = hills();
  risk.ground.risk = RasterSource{"risk.tif", "", {}, {4, "ground.risk.raster"}};
  risk.places["p"] = {GeodeticPoint{37, -6, 100}, {5, "places.p"}};

  EXPECT_THAT(report(raster), HasSubstr("w.yaml:3: terrain.raster: "));
  EXPECT_THAT(report(risk), HasSubstr("w.yaml:4: ground.risk.raster: "));
  EXPECT_THAT(report(risk), HasSubstr("w.yaml:5: places.p: "));
}

TEST(WorldBuilder, GroundThatCannotBeIsRefused) {
  WorldFile file = hills();
  std::get<TerrainSpec>(file.terrain).cell = -1;

  EXPECT_THAT(report(file), HasSubstr("terrain: terrain: the cell must be greater than 0"));
}

}  // namespace
}  // namespace skein::world
