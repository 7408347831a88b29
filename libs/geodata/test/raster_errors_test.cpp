// SPDX-License-Identifier: Apache-2.0
// Rasters that cannot be used: each refused with a reason that names the file, never a crash.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "raster_files.hpp"
#include "skein/geodata/raster_reader.hpp"
#include "test_cases.hpp"

namespace skein::geodata {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using world::Extent;
using world::GeodeticPoint;

const std::string kAscii =
    "ncols 4\nnrows 4\nxllcorner -6\nyllcorner 37\ncellsize 0.01\nNODATA_value -9999\n"
    "1 2 3 4\n5 6 7 8\n9 10 11 12\n13 14 15 16\n";

std::string report(const std::string& path, const ElevationOptions& options = {}) {
  const auto elevation = read_elevation(path, options);
  if (elevation) return "";
  EXPECT_EQ(elevation.error().all()[0].file, path);
  return to_text(elevation.error());
}

ElevationOptions in_degrees() {
  ElevationOptions options;
  options.crs = "EPSG:4326";
  return options;
}

TEST(RasterErrors, AFileThatIsNotThereOrIsNone) {
  const TempFolder folder;

  EXPECT_THAT(report(folder.path("none.tif")),
              AllOf(StartsWith(folder.path("none.tif")), HasSubstr("there is no such file")));
  EXPECT_THAT(report(folder.path("")), HasSubstr("this is not a file"));
  EXPECT_THAT(report("/vsicurl/http://localhost/a.tif"), HasSubstr("there is no such file"))
      << "no servers, whatever GDAL can do";
}

TEST(RasterErrors, AFileOfAnotherKind) {
  const TempFolder folder;

  EXPECT_THAT(report(folder.write("a.tif", "this is no raster")),
              AllOf(HasSubstr("it cannot be read as a raster"), HasSubstr("expected a GeoTIFF")));
  EXPECT_THAT(report(folder.write("empty.asc", "")), HasSubstr("it cannot be read as a raster"));
  const std::string vrt = "<VRTDataset rasterXSize=\"9\" rasterYSize=\"9\"></VRTDataset>";
  EXPECT_THAT(report(folder.write("a.vrt", vrt)), HasSubstr("it cannot be read"))
      << "a file that could name others";
}

TEST(RasterErrors, NothingIsPrintedByGdal) {
  const TempFolder folder;
  const std::string path = write_tiff(folder, "a.tif", {});
  const std::string cut = folder.write("cut.tif", content_of(path).substr(0, 900));

  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  const std::string said = report(cut);

  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_NE(said, "");
}

TEST(RasterErrors, ATruncatedGeoTiffIsDamaged) {
  const TempFolder folder;
  const std::string whole = content_of(write_tiff(folder, "a.tif", {}));

  for (std::size_t size = 0; size < whole.size(); size += 97)
    EXPECT_NE(report(folder.write("cut.tif", whole.substr(0, size))), "") << size;
}

TEST(RasterErrors, ATruncatedAsciiGridIsDamaged) {
  const TempFolder folder;

  EXPECT_EQ(report(folder.write("a.asc", kAscii), in_degrees()), "");
  EXPECT_THAT(report(folder.write("b.asc", kAscii.substr(0, kAscii.find("9 10"))), in_degrees()),
              HasSubstr("8 values for ncols × nrows = 16 cells"));
  for (std::size_t size = 0; size + 3 < kAscii.size(); ++size)
    report(folder.write("cut.asc", kAscii.substr(0, size)), in_degrees());
}

TEST(RasterErrors, AHeaderThatPromisesMoreThanThereIs) {
  const TempFolder folder;
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = kAscii;
    text.replace(text.find(from), from.size(), to);
    return report(folder.write("h.asc", text), in_degrees());
  };

  EXPECT_NE(with("ncols 4", "ncols 2000000000"), "");
  EXPECT_NE(with("nrows 4", "nrows 2000000000"), "");
  EXPECT_NE(with("ncols 4", "ncols -4"), "");
  EXPECT_NE(with("cellsize 0.01", "cellsize 0"), "");
  EXPECT_NE(with("cellsize 0.01", "cellsize nan"), "");
  EXPECT_NE(with("xllcorner -6", "xllcorner inf"), "");
  EXPECT_NE(with("ncols 4", "ncols 1"), "") << "no ground between";
}

TEST(RasterErrors, CoordinatesThatAreNotKnownMustBeSaid) {
  const TempFolder folder;
  const std::string path = folder.write("a.asc", kAscii);

  EXPECT_THAT(report(path), AllOf(HasSubstr("it does not say in which coordinates it is"),
                                  HasSubstr("crs: EPSG:4326")));
  ElevationOptions unknown;
  unknown.crs = "EPSG:999999";
  EXPECT_THAT(report(path, unknown),
              HasSubstr("unknown coordinate reference system 'EPSG:999999'"));
  unknown.crs = "/etc/passwd";
  EXPECT_THAT(report(path, unknown), HasSubstr("unknown coordinate reference system"));
}

TEST(RasterErrors, AnotherProjectionThanTheFileSays) {
  const TempFolder folder;
  ElevationOptions options;
  options.crs = "EPSG:32630";

  EXPECT_THAT(report(write_tiff(folder, "a.tif", {}), options),
              HasSubstr("it says that it is in WGS 84, not in EPSG:32630"));
  EXPECT_EQ(report(write_tiff(folder, "a.tif", {}), in_degrees()), "");
}

TEST(RasterErrors, ProjectionsThatSayNothingOfEarth) {
  const TempFolder folder;
  TiffSpec local;
  local.crs = R"(LOCAL_CS["a plan",UNIT["metre",1]])";

  EXPECT_THAT(report(write_tiff(folder, "plan.tif", local)), HasSubstr("wrong projection"));
}

TEST(RasterErrors, MetresDeclaredAsDegrees) {
  const TempFolder folder;
  TiffSpec spec;
  spec.to_map = {440'000, 30, 0, 4'100'000, 0, -30};

  EXPECT_THAT(report(write_tiff(folder, "a.tif", spec)),
              HasSubstr("wrong projection: a corner at longitude 440000"));
}

TEST(RasterErrors, ARasterThatIsNowhere) {
  const TempFolder folder;
  TiffSpec spec;
  spec.to_map = {-6, 0, 0, 37, 0, 0};
  TiffSpec far;
  far.to_map = {1e12, 30, 0, 1e12, 0, -30};
  far.crs = "EPSG:32630";

  EXPECT_NE(report(write_tiff(folder, "flat.tif", spec)), "");
  EXPECT_NE(report(write_tiff(folder, "far.tif", far)), "");
}

TEST(RasterErrors, CellsWithoutDataAreCountedAndTheFirstIsNamed) {
  const TempFolder folder;
  TiffSpec spec;
  spec.no_data = -9999;
  spec.value = [](int column, int row) {
    return (column == 12 && row == 9) || (column == 20 && row == 15) ? -9999 : 100;
  };

  EXPECT_THAT(report(write_tiff(folder, "hole.tif", spec)),
              AllOf(HasSubstr("2 cells without data where ground is wanted"),
                    HasSubstr("column 13, row 10 (latitude 37.01050, longitude -6.00750)"),
                    HasSubstr("nodata: NUMBER")));
  spec.value = [](int, int) { return std::nan(""); };
  EXPECT_THAT(report(write_tiff(folder, "nan.tif", spec)), HasSubstr("without data"));
}

TEST(RasterErrors, FiguresThatAreNoElevations) {
  const TempFolder folder;
  TiffSpec spec;
  spec.value = [](int column, int) { return column == 20 ? 1e30 : 100; };
  TiffSpec fathoms;
  fathoms.unit = "fathom";

  EXPECT_THAT(report(write_tiff(folder, "high.tif", spec)),
              HasSubstr("an elevation of 1e+30 m in column 21, row 1 (latitude"));
  spec.value = [](int column, int) { return column == 3 ? -32768 : 100; };
  EXPECT_THAT(report(write_tiff(folder, "undeclared.tif", spec)),
              HasSubstr("what stands for no data must be declared"));
  spec.value = [](int column, int) { return column == 3 ? -9999 : 100; };
  EXPECT_THAT(report(write_tiff(folder, "minus_9999.tif", spec)),
              HasSubstr("an elevation of -9999 m in column 4, row 1"));
  EXPECT_THAT(report(write_tiff(folder, "fathoms.tif", fathoms)),
              HasSubstr("its elevations are in 'fathom'"));
}

TEST(RasterErrors, WordsAndMissingValuesInAnAsciiGrid) {
  const TempFolder folder;
  const auto with = [&](const std::string& value) {
    std::string grid = kAscii;
    grid.replace(grid.find("10 11"), 2, value);
    return report(folder.write("a.asc", grid), in_degrees());
  };
  EXPECT_THAT(with("rocks"), HasSubstr("line 9: 'rocks' is no number"));
  EXPECT_THAT(with("10x"), HasSubstr("line 9: '10x' is no number"));
  EXPECT_THAT(with("10 10"), HasSubstr("17 values for ncols × nrows = 16 cells"));
  for (const char* right : {"10", "+10.5", "1.05e1", "-3"}) EXPECT_EQ(with(right), "") << right;
}

TEST(RasterErrors, WhatIsNotANumberIsAWordInAnAsciiGridDeclaredOrNot) {
  const TempFolder folder;
  const auto with = [&](const std::string& value, const std::string& no_data = "") {
    std::string grid = kAscii;
    grid.replace(grid.find("10 11"), 2, value);
    if (const std::size_t declared = grid.find("-9999"); !no_data.empty())
      grid.replace(declared, 5, no_data);
    return report(folder.write("a.asc", grid), in_degrees());
  };
  for (const char* word : {"nan", "NaN", "inf", "-Infinity"})
    EXPECT_THAT(with(word), HasSubstr(std::string("'") + word + "' is no number"));
  EXPECT_THAT(with("NaN", "nan"), HasSubstr("'NaN' is no number"));
  TiffSpec holes;
  holes.value = [](int column, int) { return column == 3 ? std::nan("") : 100; };
  EXPECT_THAT(report(write_tiff(folder, "holes.tif", holes)), HasSubstr("without data"));
}

TEST(RasterErrors, GroundBeyondTheRaster) {
  const TempFolder folder;
  const std::string path = write_tiff(folder, "a.tif", {});
  ElevationOptions elsewhere;
  elsewhere.origin = GeodeticPoint{48, 2, 0};
  elsewhere.extent = Extent{-100, -100, 100, 100};
  ElevationOptions partly;
  partly.origin = GeodeticPoint{37.005, -6, 100};
  partly.extent = Extent{-100, -100, 100, 5000};

  EXPECT_THAT(report(path, elsewhere), HasSubstr("reaches beyond it, at latitude 47.99"));
  EXPECT_THAT(report(path, partly), HasSubstr("reaches beyond it"));
}

TEST(RasterErrors, ARasterSmallerThanOneCellOfTheTerrain) {
  const TempFolder folder;
  ElevationOptions options = in_degrees();
  options.cell = 50'000;

  EXPECT_THAT(report(folder.write("a.asc", kAscii), options),
              HasSubstr("does not cover one cell of the terrain"));
}

TEST(RasterErrors, TooManyCells) {
  const TempFolder folder;
  ElevationOptions fine;
  fine.cell = 0.1;
  TiffSpec large;
  large.columns = 8000;
  large.rows = 8000;
  large.to_map = {-7, 0.00025, 0, 38, 0, -0.00025};
  large.sparse = true;

  EXPECT_THAT(report(write_tiff(folder, "a.tif", {}), fine), HasSubstr("more than 4 million"));
  write_tiff(folder, "large.tif", large);
  const auto risk =
      read_risk(folder.path("large.tif"), {-80'000, -100'000, 500, 320, 400}, {37, -6, 0});
  ASSERT_FALSE(risk);
  EXPECT_THAT(to_text(risk.error()), HasSubstr("too many to be held"));
}

TEST(RasterErrors, ARasterOfAHundredMillionPostsIsUsedWhole) {
  const TempFolder folder;
  TiffSpec large;
  large.columns = large.rows = 10'000;
  large.to_map = {-7, 0.0002, 0, 38, 0, -0.0002};
  large.sparse = true;
  ElevationOptions options;
  // Without one: four million corners, which take some seconds.
  if (!skein::testing::long_tests()) options.cell = 2000;
  const auto elevation = read_elevation(write_tiff(folder, "large.tif", large), options);
  ASSERT_TRUE(elevation) << to_text(elevation.error());
  EXPECT_EQ(elevation->decimated, 2);
  EXPECT_GT(elevation->terrain.north - elevation->terrain.south, 215'000);
  EXPECT_LE(elevation->terrain.elevations.size(), 4'000'000U);
  EXPECT_TRUE(options.cell || elevation->terrain.elevations.size() > 3'600'000);
}

TEST(RasterErrors, OptionsThatCannotBe) {
  const TempFolder folder;
  const std::string path = write_tiff(folder, "a.tif", {});
  const double nan = std::nan("");
  ElevationOptions options;
  options.cell = nan;
  EXPECT_THAT(report(path, options), HasSubstr("the cell must be greater than 0"));
  options = {};
  options.origin = GeodeticPoint{nan, 0, 0};
  EXPECT_THAT(report(path, options), HasSubstr("the origin is no place on Earth"));
  options = {};
  options.extent = Extent{0, 0, nan, 1};
  EXPECT_THAT(report(path, options), HasSubstr("the extent"));
  options.extent = Extent{10, 0, -10, 1};
  EXPECT_THAT(report(path, options), HasSubstr("east must be greater than west"));
  options = {};
  options.no_data = nan;
  EXPECT_THAT(report(path, options), HasSubstr("must be finite"));
}

TEST(RasterErrors, RisksAreFromZeroToOne) {
  const TempFolder folder;
  TiffSpec spec;
  spec.value = [](int column, int) { return column == 20 ? 1.5 : 0.5; };
  spec.no_data = -1;
  const GeodeticPoint origin{37.005, -6, 0};
  const world::Grid grid{-400, -300, 50, 16, 12};
  const auto risks = [&](const std::string& path) {
    const auto risk = read_risk(path, grid, origin);
    return risk ? "" : to_text(risk.error());
  };

  EXPECT_THAT(risks(write_tiff(folder, "risk.tif", spec)),
              AllOf(HasSubstr("a risk of 1."), HasSubstr("values from 0 to 1")));
  spec.value = [](int, int) { return -1; };
  EXPECT_THAT(risks(write_tiff(folder, "none.tif", spec)), HasSubstr("without data"));
  EXPECT_THAT(risks(folder.path("absent.tif")), HasSubstr("there is no such file"));
}

RC_GTEST_PROP(RasterErrors, NoDamageCrashes, ()) {
  static const TempFolder folder;
  static const std::string whole = content_of(write_tiff(folder, "whole.tif", {}));
  std::string damaged = whole;
  for (int i = *rc::gen::inRange(1, 6); i > 0; --i)
    damaged[*rc::gen::inRange<std::size_t>(0, i % 2 == 0 ? damaged.size() : 700)] =
        static_cast<char>(*rc::gen::inRange(0, 256));

  const auto elevation = read_elevation(folder.write("damaged.tif", damaged));

  if (elevation)
    RC_ASSERT(problems_of(elevation->terrain).empty());
  else
    RC_ASSERT(elevation.error().size() == 1u);
}

}  // namespace
}  // namespace skein::geodata
