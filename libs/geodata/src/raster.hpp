// SPDX-License-Identifier: Apache-2.0
// One raster file: where its cells are on Earth, and what they hold.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "gdal_session.hpp"
#include "skein/foundation/result.hpp"
#include "skein/world/geodetic.hpp"
#include "skein/world/geometry.hpp"

class GDALDataset;
class OGRCoordinateTransformation;

namespace skein::geodata {

/// Why a raster cannot be used, and what would have been right (may be empty).
struct RasterProblem {
  std::string message;
  std::string expected;
};

/// Cells of a raster, columns eastward and rows southward where it is not turned.
struct PixelWindow {
  int column = 0, row = 0, columns = 0, rows = 0;
  std::size_t count() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
};

/// Most cells that are held at once (128 MB).
inline constexpr std::size_t kMostPixels = 32'000'000;

/// The first band of a file that is open. Places are (column, row) where (0, 0) is the middle of
/// the first cell. Thread rule: the thread of its session.
class Raster {
 public:
  /// `crs`: for a file that does not say in which coordinates it is; may be empty. The session must
  /// outlive the raster.
  static Result<Raster, RasterProblem> open(const std::string& path, const std::string& crs,
                                            GdalSession& session);
  Raster(Raster&&) noexcept;
  Raster& operator=(Raster&&) noexcept;
  ~Raster();

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// To (column, row), altitudes left out; NaN for what has no place in its projection. Cheaper for
  /// many points than for each.
  std::vector<world::Vector2> places_of(const std::vector<world::GeodeticPoint>& points) const;
  /// Back from (column, row), at altitude 0; NaN likewise.
  std::vector<world::GeodeticPoint> points_at(const std::vector<world::Vector2>& places) const;

  /// Row-major from the first row; NaN where there are no data. Lengths in metres whatever unit the
  /// file has, if `lengths`. Precondition: inside, at most kMostPixels.
  Result<std::vector<float>, RasterProblem> read(const PixelWindow& window, bool lengths) const;

 private:
  Raster();
  Result<void, RasterProblem> find_place(const std::string& crs);
  Result<void, RasterProblem> check_degrees() const;
  Result<double, RasterProblem> unit(bool lengths) const;

  GdalSession* session_ = nullptr;
  std::unique_ptr<GDALDataset> dataset_;
  // From and to WGS 84 longitude, latitude; null when the raster is in them.
  std::unique_ptr<OGRCoordinateTransformation> from_wgs84_, to_wgs84_;
  bool in_degrees_ = false;
  std::array<double, 6> to_map_{}, to_cell_{};  // affine, as GDAL has them
  int columns_ = 0, rows_ = 0;
};

}  // namespace skein::geodata
