// SPDX-License-Identifier: Apache-2.0
#include "skein/geodata/raster_writer.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "skein/geodata/raster_reader.hpp"

namespace skein::geodata {
namespace {

constexpr world::GeodeticOrigin kOrigin{40.1, -8.2, 0};
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

class RasterWriter : public ::testing::TestWithParam<const char*> {
 protected:
  RasterWriter() { std::filesystem::create_directories(folder_); }
  ~RasterWriter() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("skein-rasters-" + std::to_string(::getpid()));
};

/// A risk that is another in each cell.
std::vector<double> unlike(const world::Grid& grid) {
  std::vector<double> values(grid.size());
  for (std::size_t cell = 0; cell < values.size(); ++cell)
    values[cell] = static_cast<double>(cell) / static_cast<double>(values.size());
  return values;
}

TEST_P(RasterWriter, WhatIsWrittenIsReadInTheSamePlace) {
  const world::Grid grid{-300, -200, 25, 30, 20};
  const std::vector<double> values = unlike(grid);

  const auto written = write_raster(path(GetParam()), grid, values, kOrigin);

  ASSERT_TRUE(written) << to_text(written.error());
  const auto read = read_risk(path(GetParam()), grid, kOrigin);
  ASSERT_TRUE(read) << to_text(read.error());
  for (std::size_t cell = 0; cell < values.size(); ++cell)
    EXPECT_NEAR((*read)[cell], values[cell], 1e-4) << cell;
}

TEST_P(RasterWriter, CellsWithoutAValueAreDeclaredToHaveNone) {
  const world::Grid grid{0, 0, 10, 3, 3};
  std::vector<double> values(9, 1);
  values[4] = kNone;
  ASSERT_TRUE(write_raster(path(GetParam()), grid, values, kOrigin));

  const auto refused = read_risk(path(GetParam()), grid, kOrigin);
  const auto filled = read_risk(path(GetParam()), grid, kOrigin, {.no_data = 0.25, .crs = ""});

  EXPECT_FALSE(refused);
  ASSERT_TRUE(filled) << to_text(filled.error());
  EXPECT_NEAR((*filled)[4], 0.25, 1e-3);
}

TEST_P(RasterWriter, SaysThatAPlaceCannotBeWritten) {
  const auto refused =
      write_raster(path(std::string("nowhere/") + GetParam()), {0, 0, 1, 1, 1}, {0}, kOrigin);

  ASSERT_FALSE(refused);
  EXPECT_NE(to_text(refused.error()).find("nowhere"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Formats, RasterWriter, ::testing::Values("out.tif", "out.asc"));

TEST(RasterNames, AreKnownByTheirEnding) {
  EXPECT_TRUE(is_raster_name("a.TIF"));
  EXPECT_TRUE(is_raster_name("b.asc"));
  EXPECT_FALSE(is_raster_name("c.geojson"));
  EXPECT_FALSE(write_raster("c.png", {0, 0, 1, 1, 1}, {0}, kOrigin));
}

}  // namespace
}  // namespace skein::geodata
