// SPDX-License-Identifier: Apache-2.0
// Elevations: values against oracles that do not use GDAL.
#include "skein/geodata/raster_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <GeographicLib/TransverseMercator.hpp>

#include <cmath>

#include "raster_files.hpp"
#include "skein/geodesy/geodetic_frame.hpp"

namespace skein::geodata {
namespace {

using world::Extent;
using world::GeodeticPoint;
using world::TerrainCorners;
using world::TerrainSpec;
using world::Vector3;

const std::string kJacksboro = SKEIN_SOURCE_DIR "/scenarios/terrain/jacksboro.asc";

Elevation read(const std::string& path, const ElevationOptions& options = {}) {
  auto elevation = read_elevation(path, options);
  if (!elevation) ADD_FAILURE() << to_text(elevation.error());
  return elevation ? *elevation : Elevation();
}

/// Asks `expected` for the altitude of the ground at each corner's true place on Earth, and gives
/// the greatest difference [m].
double worst_error(const Elevation& elevation,
                   const std::function<double(const GeodeticPoint&)>& expected) {
  const TerrainSpec& terrain = elevation.terrain;
  const geodesy::GeodeticFrame frame(elevation.origin);
  const TerrainCorners corners = corners_of(terrain);
  double worst = 0;
  for (std::size_t row = 0; row < corners.rows; ++row)
    for (std::size_t column = 0; column < corners.columns; ++column) {
      const double z = terrain.elevations[row * corners.columns + column];
      const GeodeticPoint at =
          frame.to_geodetic({terrain.west + static_cast<double>(column) * terrain.cell,
                             terrain.south + static_cast<double>(row) * terrain.cell, z});
      worst = std::max(worst, std::abs(at.altitude - expected(at)));
    }
  return worst;
}

/// An ESRI ASCII grid, read without GDAL.
struct AsciiGrid {
  std::size_t columns = 0, rows = 0;
  double west = 0, south = 0, cell = 0, no_data = 0;
  std::vector<double> values;  // first row north

  explicit AsciiGrid(const std::string& path) {
    std::ifstream in(path);
    std::string key;
    in >> key >> columns >> key >> rows >> key >> west >> key >> south >> key >> cell >> key >>
        no_data;
    for (double value = 0; in >> value;) values.push_back(value);
  }
  double at(const GeodeticPoint& point) const {
    const double u = (point.longitude_degrees - west) / cell - 0.5;
    const double v = static_cast<double>(rows) - (point.latitude_degrees - south) / cell - 0.5;
    const auto column = static_cast<std::size_t>(u), row = static_cast<std::size_t>(v);
    const double fu = u - std::floor(u), fv = v - std::floor(v);
    const auto value = [&](std::size_t c, std::size_t r) { return values[r * columns + c]; };
    return (value(column, row) * (1 - fu) + value(column + 1, row) * fu) * (1 - fv) +
           (value(column, row + 1) * (1 - fu) + value(column + 1, row + 1) * fu) * fv;
  }
};

TEST(ReadElevation, RealGroundIsWhatTheAsciiGridSays) {
  const AsciiGrid grid(kJacksboro);
  ASSERT_EQ(grid.values.size(), 403u * 344);
  ElevationOptions options;
  options.origin = GeodeticPoint{36.5895, -84.246, 300};
  options.extent = Extent{-9000, -8000, 9000, 8000};
  options.cell = 50;
  options.crs = "EPSG:4326";

  const Elevation elevation = read(kJacksboro, options);

  ASSERT_EQ(elevation.terrain.elevations.size(), 361u * 321);
  EXPECT_LT(worst_error(elevation, [&](const GeodeticPoint& p) { return grid.at(p); }), 2e-3);
}

TEST(ReadElevation, WithoutOptionsAllOfTheRasterIsTakenFromItsLowestPlace) {
  const AsciiGrid grid(kJacksboro);
  ElevationOptions options;
  options.crs = "EPSG:4326";

  const Elevation elevation = read(kJacksboro, options);

  EXPECT_NEAR(elevation.origin.longitude_degrees, grid.west + 403 * grid.cell / 2, 1e-9);
  EXPECT_NEAR(elevation.origin.latitude_degrees, grid.south + 344 * grid.cell / 2, 1e-9);
  EXPECT_EQ(elevation.origin.altitude, 236);
  EXPECT_EQ(elevation.terrain.cell, 83) << "between 74 m and 93 m";
  EXPECT_GT(elevation.terrain.east - elevation.terrain.west, 0.99 * 402 * 74.3);
  EXPECT_GT(elevation.terrain.north - elevation.terrain.south, 0.99 * 343 * 92.4);
  EXPECT_LT(worst_error(elevation, [&](const GeodeticPoint& p) { return grid.at(p); }), 2e-3);
}

TEST(ReadElevation, LevelGroundBendsWithTheEarth) {
  const TempFolder folder;
  const std::string path = write_tiff(folder, "level.tif", {});
  ElevationOptions options;
  options.origin = GeodeticPoint{37.005, -6, 100};

  const Elevation elevation = read(path, options);

  EXPECT_LT(worst_error(elevation, [](const GeodeticPoint&) { return 100.0; }), 1e-4);
  const double west = elevation.terrain.west, south = elevation.terrain.south;
  EXPECT_NEAR(elevation.terrain.elevations[0], -(west * west + south * south) / 2 / 6.38e6, 0.02);
}

/// The plane's height where a place is in UTM zone 30, by GeographicLib instead of PROJ.
double plane_in_utm30(const GeodeticPoint& point) {
  double x = 0, y = 0;
  GeographicLib::TransverseMercator::UTM().Forward(-3, point.latitude_degrees,
                                                   point.longitude_degrees, x, y);
  return 500 + (x + 500'000 - 440'000) * 0.03 - (y - 4'100'000) * 0.02;
}

TiffSpec utm_plane() {
  TiffSpec spec;
  spec.columns = 120;
  spec.rows = 90;
  spec.to_map = {440'000, 30, 0, 4'100'000, 0, -30};
  spec.crs = "EPSG:32630";
  spec.type = GDT_Float64;
  spec.value = [](int column, int row) {
    return 500 + (column + 0.5) * 30 * 0.03 + (row + 0.5) * 30 * 0.02;
  };
  return spec;
}

TEST(ReadElevation, AProjectedRasterIsTakenWhereItIsOnEarth) {
  const TempFolder folder;

  const Elevation elevation = read(write_tiff(folder, "utm.tif", utm_plane()));

  EXPECT_EQ(elevation.terrain.cell, 30);
  EXPECT_GT(elevation.terrain.elevations.size(), 110u * 80);
  EXPECT_LT(worst_error(elevation, plane_in_utm30), 1e-3);
}

TEST(ReadElevation, ARasterWithItsFirstRowInTheSouthIsTheSameGround) {
  const TempFolder folder;
  TiffSpec spec = utm_plane();
  spec.to_map = {440'000, 30, 0, 4'100'000 - 90 * 30, 0, 30};
  spec.value = [north = utm_plane().value](int column, int row) { return north(column, 89 - row); };

  const Elevation elevation = read(write_tiff(folder, "south.tif", spec));

  EXPECT_LT(worst_error(elevation, plane_in_utm30), 1e-3);
}

TEST(ReadElevation, AnAsciiGridFindsItsProjectionBesideIt) {
  const TempFolder folder;
  std::string text = "ncols 40\nnrows 40\nxllcorner 440000\nyllcorner 4099000\ncellsize 25\n";
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 40; ++column)
      text += std::to_string(500 + (column + 0.5) * 25 * 0.03 + (row + 0.5) * 25 * 0.02) +
              (column == 39 ? "\n" : " ");
  const std::string path = folder.write("plane.asc", text);
  folder.write("plane.prj",
               R"(PROJCS["WGS 84 / UTM zone 30N",GEOGCS["WGS 84",DATUM["WGS_1984",)"
               R"(SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],)"
               R"(UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],)"
               R"(PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",-3],)"
               R"(PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],)"
               R"(PARAMETER["false_northing",0],UNIT["metre",1]])");

  const Elevation elevation = read(path);

  EXPECT_LT(worst_error(elevation, plane_in_utm30), 2e-3);
}

TEST(ReadElevation, ARasterAcrossTheDateLineIsOnePiece) {
  const TempFolder folder;
  TiffSpec spec;
  spec.to_map = {179.98, 0.001, 0, -16.985, 0, -0.001};
  spec.value = [](int column, int) { return column * 1.0; };

  const Elevation elevation = read(write_tiff(folder, "fiji.tif", spec));

  EXPECT_NEAR(std::abs(elevation.origin.longitude_degrees), 180, 1e-6);
  const auto column_at = [](const GeodeticPoint& p) {
    const double east = p.longitude_degrees + (p.longitude_degrees < 0 ? 360 : 0);
    return (east - 179.98) / 0.001 - 0.5;
  };
  EXPECT_LT(worst_error(elevation, column_at), 1e-3);
}

TEST(ReadElevation, FeetBecomeMetres) {
  const TempFolder folder;
  TiffSpec spec;
  spec.unit = "ft";

  const Elevation elevation = read(write_tiff(folder, "feet.tif", spec));

  EXPECT_NEAR(elevation.origin.altitude, 30.48, 1e-4);
}

TEST(ReadElevation, CellsWithoutDataAreReplacedWhenThatIsAsked) {
  const TempFolder folder;
  TiffSpec spec;
  spec.no_data = -9999;
  spec.value = [](int column, int row) { return column == 20 && row == 15 ? -9999 : 100; };
  ElevationOptions options;
  options.no_data = 40;

  const Elevation elevation = read(write_tiff(folder, "hole.tif", spec), options);

  EXPECT_EQ(elevation.origin.altitude, 40);
}

TEST(ReadElevation, CellsWithoutDataThatAreNotWantedDoNotCount) {
  const TempFolder folder;
  TiffSpec spec;
  spec.no_data = -9999;
  spec.value = [](int column, int) { return column < 8 ? -9999 : 100; };
  ElevationOptions options;
  options.origin = GeodeticPoint{37.005, -6, 100};
  options.extent = Extent{-300, -300, 300, 300};

  const Elevation elevation = read(write_tiff(folder, "edge.tif", spec), options);

  EXPECT_LT(worst_error(elevation, [](const GeodeticPoint&) { return 100.0; }), 1e-4);
}

TEST(ReadElevation, APartOfALargeRasterIsReadAlone) {
  const TempFolder folder;
  TiffSpec spec;
  spec.columns = 8000;
  spec.rows = 8000;
  spec.to_map = {-7, 0.00025, 0, 38, 0, -0.00025};
  spec.sparse = true;
  const std::string path = write_tiff(folder, "large.tif", spec);
  ElevationOptions options;
  options.origin = GeodeticPoint{37, -6, 0};
  options.extent = Extent{-500, -500, 500, 500};

  const Elevation elevation = read(path, options);

  EXPECT_EQ(elevation.terrain.cell, 25) << "22 m and 28 m, in the mean";
}

TEST(ReadRisk, IsTheRiskAtTheMiddleOfEachCell) {
  const TempFolder folder;
  TiffSpec spec;
  spec.value = [](int column, int) { return column / 100.0; };
  const std::string path = write_tiff(folder, "risk.tif", spec);
  const GeodeticPoint origin{37.005, -6, 0};
  const world::Grid grid{-400, -300, 100, 8, 6};

  const auto risk = read_risk(path, grid, origin);

  ASSERT_TRUE(risk) << to_text(risk.error());
  const geodesy::GeodeticFrame frame(origin);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const GeodeticPoint at = frame.to_geodetic({grid.centre(i).x(), grid.centre(i).y(), 0});
    EXPECT_NEAR((*risk)[i], ((at.longitude_degrees + 6.02) / 0.001 - 0.5) / 100, 1e-6);
  }
}

}  // namespace
}  // namespace skein::geodata
