// SPDX-License-Identifier: Apache-2.0
// Rasters made for tests, in a folder of their own.
#pragma once

#include <gdal.h>
#include <gdal_frmts.h>
#include <gtest/gtest.h>
#include <ogr_srs_api.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace skein::geodata {

/// Gone when the test ends.
class TempFolder {
 public:
  TempFolder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("skein_geodata_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  std::string path(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

 private:
  std::filesystem::path path_;
};

inline std::string content_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What a GeoTIFF of a test is like.
struct TiffSpec {
  int columns = 40, rows = 30;
  std::array<double, 6> to_map{-6.02, 0.001, 0, 37.02, 0, -0.001};  // GDAL's
  std::string crs = "EPSG:4326";                                    // empty: none
  std::function<double(int column, int row)> value = [](int, int) { return 100.0; };
  std::optional<double> no_data;
  std::string unit;
  GDALDataType type = GDT_Float32;
  bool sparse = false;  // no value is written
};

inline std::string write_tiff(const TempFolder& folder, const std::string& name,
                              const TiffSpec& spec) {
  GDALRegister_GTiff();
  const std::string path = folder.path(name);
  std::array<const char*, 2> options = {"SPARSE_OK=TRUE", nullptr};
  GDALDatasetH file = GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), spec.columns,
                                 spec.rows, 1, spec.type, const_cast<char**>(options.data()));
  std::array<double, 6> to_map = spec.to_map;
  GDALSetGeoTransform(file, to_map.data());
  if (!spec.crs.empty()) {
    OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
    EXPECT_EQ(OSRSetFromUserInput(reference, spec.crs.c_str()), OGRERR_NONE);
    GDALSetSpatialRef(file, reference);
    OSRRelease(reference);
  }
  GDALRasterBandH band = GDALGetRasterBand(file, 1);
  if (spec.no_data) GDALSetRasterNoDataValue(band, *spec.no_data);
  if (!spec.unit.empty()) GDALSetRasterUnitType(band, spec.unit.c_str());
  std::vector<double> line(static_cast<std::size_t>(spec.columns));
  for (int row = 0; row < spec.rows && !spec.sparse; ++row) {
    for (int column = 0; column < spec.columns; ++column)
      line[static_cast<std::size_t>(column)] = spec.value(column, row);
    EXPECT_EQ(GDALRasterIO(band, GF_Write, 0, row, spec.columns, 1, line.data(), spec.columns, 1,
                           GDT_Float64, 0, 0),
              CE_None);
  }
  GDALClose(file);
  return path;
}

}  // namespace skein::geodata
