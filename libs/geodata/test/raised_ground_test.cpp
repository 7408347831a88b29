// SPDX-License-Identifier: Apache-2.0
// No post of a raster stands out of the ground that is planned over, at any size of cell; judged by
// the raster itself, without GDAL, walked at a quarter of its cell.
#include <gtest/gtest.h>

#include <cmath>

#include "raster_files.hpp"
#include "skein/geodata/raster_reader.hpp"
#include "skein/geodesy/geodetic_frame.hpp"

namespace skein::geodata {
namespace {

using world::GeodeticPoint;
using world::Vector3;

const std::string kJacksboro = SKEIN_SOURCE_DIR "/scenarios/terrain/jacksboro.asc";
constexpr double kMargin = 0.02;  // [m] the Earth between two posts is no straight line

/// Posts in degrees, the first row in the north.
struct Posts {
  std::size_t columns = 0, rows = 0;
  double west = 0, south = 0, step = 0;
  std::vector<double> values;

  static Posts of_ascii(const std::string& path) {
    Posts posts;
    std::ifstream in(path);
    std::string key;
    double no_data = 0;
    in >> key >> posts.columns >> key >> posts.rows >> key >> posts.west >> key >> posts.south >>
        key >> posts.step >> key >> no_data;
    for (double value = 0; in >> value;) posts.values.push_back(value);
    return posts;
  }
  GeodeticPoint at(double column, double row) const {
    const auto c = std::min(static_cast<std::size_t>(column), columns - 2);
    const auto r = std::min(static_cast<std::size_t>(row), rows - 2);
    const double s = column - static_cast<double>(c), t = row - static_cast<double>(r);
    const auto value = [&](std::size_t i, std::size_t j) { return values[j * columns + i]; };
    return {south + (static_cast<double>(rows) - 0.5 - row) * step, west + (column + 0.5) * step,
            (1 - t) * ((1 - s) * value(c, r) + s * value(c + 1, r)) +
                t * ((1 - s) * value(c, r + 1) + s * value(c + 1, r + 1))};
  }
};

struct Walked {
  double out_posts = 0, out_between = 0;  ///< what stands out of the ground, at most [m]
  double above = 0;                       ///< of the ground over the posts, mean [m]
};

/// At every post and, in its part in the middle, at quarters between.
Walked walk(const Posts& posts, const Elevation& elevation) {
  const geodesy::GeodeticFrame frame(elevation.origin);
  const world::Terrain ground(elevation.terrain);
  Walked walked;
  double count = 0;
  for (double row = 0; row + 1 < static_cast<double>(posts.rows); row += 0.25)
    for (double column = 0; column + 1 < static_cast<double>(posts.columns); column += 0.25) {
      const bool is_post = row == std::floor(row) && column == std::floor(column);
      if (!is_post && (row < 150 || row > 190 || column < 150 || column > 190)) continue;
      const Vector3 at = frame.to_local(posts.at(column, row));
      if (!ground.contains(at.x(), at.y())) continue;
      const double over = ground.elevation(at.x(), at.y()) - at.z();
      walked.out_between = std::max(walked.out_between, -over);
      if (!is_post) continue;
      walked.out_posts = std::max(walked.out_posts, -over);
      walked.above += over;
      count += 1;
    }
  walked.above /= count;
  return walked;
}

Elevation jacksboro(double cell, bool above_posts) {
  ElevationOptions options;
  options.crs = "EPSG:4326";
  options.cell = cell;
  options.above_posts = above_posts;
  auto elevation = read_elevation(kJacksboro, options);
  if (!elevation) ADD_FAILURE() << to_text(elevation.error());
  return elevation.value_or(Elevation());
}

TEST(RaisedGround, NoPostStandsOutAtAnySizeOfCell) {
  const Posts posts = Posts::of_ascii(kJacksboro);
  for (const double cell : {60.0, 83.0, 250.0}) {
    const Elevation raised = jacksboro(cell, true);
    const Walked walked = walk(posts, raised);
    EXPECT_LE(walked.out_posts, kMargin) << cell;
    // A grid that is turned against the raster's is not above all of what is between its posts.
    EXPECT_LE(walked.out_between, 1) << cell;
    EXPECT_GT(raised.raised_mean, 0);
    EXPECT_GT(raised.raised_most, raised.raised_mean);
    std::printf(
        "cell %3.0f m: corners raised by %.1f m (mean), %.1f m (most); over the posts %.1f m"
        " (mean)\n",
        cell, raised.raised_mean, raised.raised_most, walked.above);
  }
}

TEST(RaisedGround, WithoutItPostsStandOut) {
  EXPECT_GT(walk(Posts::of_ascii(kJacksboro), jacksboro(83, false)).out_posts, 5);
}

TEST(RaisedGround, ASpikeBetweenTheCornersIsCovered) {
  const TempFolder folder;
  TiffSpec spec;
  spec.value = [](int column, int row) { return column == 20 && row == 15 ? 180.0 : 100.0; };
  const std::string path = write_tiff(folder, "spike.tif", spec);
  ElevationOptions options;
  options.cell = 400;
  options.above_posts = true;
  const auto elevation = read_elevation(path, options);
  ASSERT_TRUE(elevation) << to_text(elevation.error());

  const geodesy::GeodeticFrame frame(elevation->origin);
  const Vector3 top = frame.to_local({37.02 - 15.5 * 0.001, -6.02 + 20.5 * 0.001, 180});

  EXPECT_GE(world::Terrain(elevation->terrain).elevation(top.x(), top.y()), top.z() - 0.01);
}

/// Rasters that are larger than what is held: no post of the whole one stands out.
TEST(RaisedGround, IsAboveAllPostsOfADecimatedRaster) {
  const Posts posts = Posts::of_ascii(kJacksboro);
  for (const std::size_t most : {40'000, 10'000, 1'000})
    for (const double cell : {100.0, 400.0}) {
      ElevationOptions options;
      options.crs = "EPSG:4326";
      options.cell = cell;
      options.above_posts = true;
      options.most_posts = most;
      const auto raised = read_elevation(kJacksboro, options);
      ASSERT_TRUE(raised) << to_text(raised.error());
      const Walked walked = walk(posts, *raised);
      EXPECT_GT(raised->decimated, 1);
      EXPECT_LE(walked.out_posts, kMargin) << most << ' ' << cell;
      std::printf("%zu posts at most, %d taken as one, cell %.0f m: over the posts %.1f m (mean)\n",
                  most, raised->decimated, cell, walked.above);
    }
}

TEST(RaisedGround, OfADecimatedRasterIsTheGreatestAroundEachPlace) {
  const TempFolder folder;
  TiffSpec spec;
  spec.columns = 41;
  spec.rows = 31;
  spec.value = [](int column, int row) { return 100.0 + (column * 37 + row * 59) % 83; };
  const std::string path = write_tiff(folder, "wild.tif", spec);
  ElevationOptions options;
  options.cell = 100;
  options.most_posts = 100;
  const auto elevation = read_elevation(path, options);
  ASSERT_TRUE(elevation) << to_text(elevation.error());
  EXPECT_EQ(elevation->decimated, 4);

  const geodesy::GeodeticFrame frame(elevation->origin);
  const world::Terrain ground(elevation->terrain);
  for (int row = 1; row < spec.rows - 1; ++row)
    for (int column = 1; column < spec.columns - 1; ++column) {
      double greatest = 0;  // of what a post that has a part in it may have seen
      for (int r = std::max(0, row - 11); r <= std::min(spec.rows - 1, row + 11); ++r)
        for (int c = std::max(0, column - 11); c <= std::min(spec.columns - 1, column + 11); ++c)
          greatest = std::max(greatest, spec.value(c, r));
      const Vector3 at = frame.to_local(
          {37.02 - (row + 0.5) * 0.001, -6.02 + (column + 0.5) * 0.001, spec.value(column, row)});
      if (!ground.contains(at.x(), at.y())) continue;
      EXPECT_GE(ground.elevation(at.x(), at.y()), at.z() - 0.5) << column << ' ' << row;
      EXPECT_LE(ground.elevation(at.x(), at.y()), greatest - elevation->origin.altitude + 0.5);
    }
}

TEST(RaisedGround, LevelGroundIsNotRaised) {
  const TempFolder folder;
  ElevationOptions options;
  options.above_posts = true;
  const auto elevation = read_elevation(write_tiff(folder, "level.tif", {}), options);
  ASSERT_TRUE(elevation);
  EXPECT_LT(elevation->raised_most, 0.01) << "but for the bend of the Earth";
}

}  // namespace
}  // namespace skein::geodata
