// SPDX-License-Identifier: Apache-2.0
#include "skein/geodata/raster_writer.hpp"

#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "gdal_session.hpp"
#include "skein/foundation/contract.hpp"
#include "vector_file.hpp"

namespace skein::geodata {
namespace {

/// GDAL's name of the format; null for endings that are not known.
const char* raster_driver_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".tif" || ending == ".tiff") return "GTiff";
  return ending == ".asc" ? "AAIGrid" : nullptr;
}

OGRSpatialReference around(const world::GeodeticOrigin& origin) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(),
                "+proj=aeqd +lat_0=%.12g +lon_0=%.12g +x_0=0 +y_0=0 +datum=WGS84 +units=m",
                origin.latitude_degrees, origin.longitude_degrees);
  OGRSpatialReference reference;
  reference.importFromProj4(text.data());
  return reference;
}

/// The northmost row first, as files have it.
bool fill(GDALRasterBand& band, const world::Grid& grid, const std::vector<double>& values) {
  band.SetNoDataValue(kNoValue);
  std::vector<double> row(grid.columns);
  const auto columns = static_cast<int>(grid.columns);
  for (std::size_t from_north = 0; from_north < grid.rows; ++from_north) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      const double value = values[grid.index(column, grid.rows - 1 - from_north)];
      row[column] = std::isfinite(value) ? value : kNoValue;
    }
    if (band.RasterIO(GF_Write, 0, static_cast<int>(from_north), columns, 1, row.data(), columns, 1,
                      GDT_Float64, 0, 0, nullptr) != CE_None)
      return false;
  }
  return true;
}

}  // namespace

bool is_raster_name(const std::string& path) { return raster_driver_of(path) != nullptr; }

Result<void, Diagnostics> write_raster(const std::string& path, const world::Grid& grid,
                                       const std::vector<double>& values,
                                       const world::GeodeticOrigin& origin) {
  SKEIN_EXPECTS(values.size() == grid.size());
  const char* name = raster_driver_of(path);
  if (name == nullptr)
    return wrong_file(path, "its format is not known by its name",
                      "a file that ends with .tif, .tiff or .asc");
  GdalSession session;
  GDALRegister_MEM();
  GDALDriverManager* drivers = GetGDALDriverManager();
  const std::unique_ptr<GDALDataset> made(drivers->GetDriverByName("MEM")->Create(
      "", static_cast<int>(grid.columns), static_cast<int>(grid.rows), 1, GDT_Float32, nullptr));
  const OGRSpatialReference reference = around(origin);
  const double north = grid.south + static_cast<double>(grid.rows) * grid.cell;
  std::array<double, 6> place = {grid.west, grid.cell, 0, north, 0, -grid.cell};
  const bool ready = made && made->SetGeoTransform(place.data()) == CE_None &&
                     made->SetSpatialRef(&reference) == CE_None &&
                     fill(*made->GetRasterBand(1), grid, values);
  const std::unique_ptr<GDALDataset> written(
      ready ? drivers->GetDriverByName(name)->CreateCopy(path.c_str(), made.get(), 0, nullptr,
                                                         nullptr, nullptr)
            : nullptr);
  if (!written) return wrong_file(path, "it cannot be written" + session.complaint());
  written->FlushCache();
  return {};
}

}  // namespace skein::geodata
