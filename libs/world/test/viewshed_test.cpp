// SPDX-License-Identifier: Apache-2.0
#include "skein/world/viewshed.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "skein/foundation/random.hpp"

namespace skein::world {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTool = "/usr/bin/gdal_viewshed";

/// Its cells are centred on the corners of the terrain, where its elevations are.
Grid corners_of_terrain(const TerrainSpec& spec) {
  return {spec.west - spec.cell / 2, spec.south - spec.cell / 2, spec.cell,
          static_cast<std::size_t>(std::lround((spec.east - spec.west) / spec.cell)) + 1,
          static_cast<std::size_t>(std::lround((spec.north - spec.south) / spec.cell)) + 1};
}

void write_ascii(const fs::path& file, const Terrain& terrain, const Grid& grid) {
  std::ofstream out(file);
  out.precision(12);
  out << "ncols " << grid.columns << "\nnrows " << grid.rows << "\nxllcorner " << grid.west
      << "\nyllcorner " << grid.south << "\ncellsize " << grid.cell << "\nNODATA_value -99999\n";
  for (std::size_t row = grid.rows; row-- > 0;)
    for (std::size_t column = 0; column < grid.columns; ++column) {
      const Vector2 at = grid.centre(grid.index(column, row));
      out << terrain.elevation(at.x(), at.y()) << (column + 1 < grid.columns ? ' ' : '\n');
    }
}

/// What the tool says of each cell; empty when it failed.
std::vector<bool> by_gdal(const Terrain& terrain, const Grid& grid, const Vector2& at,
                          double height, double target) {
  const fs::path directory = SKEIN_BINARY_DIR "/viewshed_test";
  fs::create_directories(directory);
  write_ascii(directory / "ground.asc", terrain, grid);
  std::ostringstream command;
  command.precision(12);
  command << kTool << " -q -cc 0 -ox " << at.x() << " -oy " << at.y() << " -oz " << height
          << " -tz " << target << " -vv 1 -iv 0 " << directory / "ground.asc" << ' '
          << directory / "seen.tif"
          << " && gdal_translate -q -of AAIGrid " << directory / "seen.tif" << ' '
          << directory / "seen.asc";
  if (std::system(command.str().c_str()) != 0) return {};
  std::ifstream in(directory / "seen.asc");
  std::string word;
  while (in >> word && word != "cellsize") {
  }
  in >> word;
  std::vector<bool> seen(grid.size());
  for (std::size_t row = grid.rows; row-- > 0;)
    for (std::size_t column = 0; column < grid.columns; ++column) {
      if (!(in >> word)) return {};
      if (word == "NODATA_value") in >> word >> word;
      seen[grid.index(column, row)] = std::atof(word.c_str()) > 0.5;
    }
  return seen;
}

/// True when the eight cells around and the cell itself agree.
bool is_inside(const std::vector<bool>& seen, const Grid& grid, std::size_t cell) {
  const auto column = static_cast<long>(cell % grid.columns),
             row = static_cast<long>(cell / grid.columns);
  for (long y = std::max(0L, row - 1); y <= std::min<long>(row + 1, long(grid.rows) - 1); ++y)
    for (long x = std::max(0L, column - 1); x <= std::min<long>(column + 1, long(grid.columns) - 1);
         ++x)
      if (seen[grid.index(std::size_t(x), std::size_t(y))] != seen[cell]) return false;
  return true;
}

struct Agreement {
  std::size_t cells = 0, agree = 0, all = 0, all_agree = 0, seen = 0;
  double share() const { return double(agree) / double(cells); }
};

Agreement compare(const std::vector<bool>& own, const std::vector<bool>& other, const Grid& grid) {
  Agreement agreement;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const bool same = own[cell] == other[cell];
    ++agreement.all;
    agreement.all_agree += same ? 1 : 0;
    agreement.seen += own[cell] ? 1 : 0;
    if (!is_inside(other, grid, cell)) continue;
    ++agreement.cells;
    agreement.agree += same ? 1 : 0;
  }
  return agreement;
}

Agreement agreement_with_gdal(const TerrainSpec& spec, const Vector2& near, double height,
                              double target) {
  const Terrain terrain(spec);
  const Grid grid = corners_of_terrain(spec);
  const Vector2 at = grid.centre(*grid.at(near));
  const std::vector<bool> other = by_gdal(terrain, grid, at, height, target);
  EXPECT_EQ(other.size(), grid.size()) << "gdal_viewshed failed";
  if (other.size() != grid.size()) return {1, 0, 1, 0, 0};
  const Vector3 eye(at.x(), at.y(), terrain.elevation(at.x(), at.y()) + height);
  const Agreement found = compare(viewshed(terrain, grid, {eye, 1e9, target}), other, grid);
  std::printf(
      "  %zu cells, %.1f %% seen; agree: %.3f %% away from the horizon band (%zu), "
      "%.3f %% of all\n",
      found.all, 100.0 * double(found.seen) / double(found.all), 100 * found.share(), found.cells,
      100.0 * double(found.all_agree) / double(found.all));
  return found;
}

TerrainSpec random_hills(std::uint64_t seed) {
  Random random(seed);
  TerrainSpec spec;
  spec.east = spec.north = 3000;
  spec.cell = 20;
  for (int i = 0; i < 25; ++i)
    spec.hills.push_back({{random.uniform(0, 3000), random.uniform(0, 3000)},
                          random.uniform(-40, 160),
                          random.uniform(150, 700)});
  return spec;
}

TEST(Viewshed, OverLevelGroundIsTheDiscOfTheRange) {
  TerrainSpec spec;
  spec.east = spec.north = 400;
  const Grid grid{0, 0, 10, 40, 40};

  const auto seen = viewshed(Terrain(spec), grid, {{200, 200, 30}, 100, 0});

  for (std::size_t cell = 0; cell < grid.size(); ++cell)
    EXPECT_EQ(seen[cell], std::hypot((grid.centre(cell) - Vector2(200, 200)).norm(), 30) <= 100);
}

TEST(Viewshed, AHillHidesTheGroundBehindIt) {
  TerrainSpec spec;
  spec.east = spec.north = 400;
  spec.hills = {{{200, 200}, 60, 80}};
  const Grid grid{0, 0, 10, 40, 40};

  const auto seen = viewshed(Terrain(spec), grid, {{20, 200, 5}});

  EXPECT_TRUE(seen[*grid.at({105, 205})]);
  EXPECT_FALSE(seen[*grid.at({295, 205})]);
  EXPECT_TRUE(seen[*grid.at({295, 15})]);
}

TEST(Viewshed, AgreesWithGdalOnHills) {
  if (!fs::exists(kTool)) GTEST_SKIP() << kTool << " is not installed (package gdal-bin)";
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Random random(seed, "eye");
    const Vector2 near(random.uniform(300, 2700), random.uniform(300, 2700));

    const Agreement found =
        agreement_with_gdal(random_hills(seed), near, random.uniform(2, 120), 1);

    EXPECT_GE(found.share(), 0.99) << "seed " << seed;
  }
}

/// Read as metric cells of 90 m: what matters here is the shape of real ground.
TerrainSpec jacksboro(std::ifstream& in) {
  std::string word;
  double columns = 0, rows = 0;
  in >> word >> columns >> word >> rows;
  for (int i = 0; i < 8; ++i) in >> word;
  TerrainSpec spec;
  spec.cell = 90;
  spec.east = 90 * (columns - 1);
  spec.north = 90 * (rows - 1);
  const auto across = static_cast<std::size_t>(columns), along = static_cast<std::size_t>(rows);
  spec.elevations.resize(across * along);
  for (std::size_t row = along; row-- > 0;)
    for (std::size_t column = 0; column < across; ++column)
      in >> spec.elevations[row * across + column];
  EXPECT_TRUE(in);
  return spec;
}

TEST(Viewshed, AgreesWithGdalOnRealGround) {
  const char* const file = SKEIN_SOURCE_DIR "/../shared/data/geometry/jacksboro.asc";
  std::ifstream in(file);
  if (!in) GTEST_SKIP() << file << " is not there";
  if (!fs::exists(kTool)) GTEST_SKIP() << kTool << " is not installed (package gdal-bin)";
  const TerrainSpec spec = jacksboro(in);
  for (const auto& [x, y, height] :
       {std::tuple{12000.0, 9000.0, 100.0}, std::tuple{24000.0, 20000.0, 300.0},
        std::tuple{18000.0, 15500.0, 30.0}}) {
    const Agreement found = agreement_with_gdal(spec, {x, y}, height, 2);

    EXPECT_GE(found.share(), 0.99) << x << ' ' << y;
  }
}

}  // namespace
}  // namespace skein::world
