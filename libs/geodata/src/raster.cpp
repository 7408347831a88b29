// SPDX-License-Identifier: Apache-2.0
#include "raster.hpp"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <optional>

#include "ascii_grid.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::geodata {

using world::GeodeticPoint;
using world::Vector2;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

tl::unexpected<RasterProblem> problem(std::string message, std::string expected = "") {
  return tl::make_unexpected(RasterProblem{std::move(message), std::move(expected)});
}

OGRSpatialReference wgs84() {
  OGRSpatialReference reference;
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  reference.importFromEPSG(4326);
  return reference;
}

/// In whatever order its axes are named.
bool same(const OGRSpatialReference& a, const OGRSpatialReference& b) {
  static constexpr std::array<const char*, 3> kOptions = {
      "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", "CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS",
      nullptr};
  return a.IsSame(&b, kOptions.data()) != 0;
}

Result<OGRSpatialReference, RasterProblem> reference_of(GDALDataset& dataset,
                                                        const std::string& crs,
                                                        GdalSession& session) {
  std::optional<OGRSpatialReference> given;
  if (!crs.empty()) {
    given.emplace();
    if (given->SetFromUserInput(
            crs.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) != OGRERR_NONE)
      return problem("unknown coordinate reference system '" + crs + "'" + session.complaint(),
                     "a name as EPSG:4326");
  }
  const OGRSpatialReference* own = dataset.GetSpatialRef();
  if (own == nullptr && !given)
    return problem("it does not say in which coordinates it is",
                   "a file that says it (a .prj beside an ESRI ASCII grid), or a crs: EPSG:4326 "
                   "for longitude and latitude on WGS 84");
  if (own != nullptr && given && !same(*own, *given))
    return problem("it says that it is in " + std::string(own->GetName()) + ", not in " + crs,
                   "no crs: that of the file counts");
  OGRSpatialReference reference = own != nullptr ? *own : *given;
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (reference.IsGeographic() == 0 && reference.IsProjected() == 0)
    return problem("wrong projection: its coordinates (" + std::string(reference.GetName()) +
                       ") are neither longitude and latitude nor a map projection",
                   "a raster in WGS 84 or in a projected coordinate reference system");
  return reference;
}

}  // namespace

Raster::Raster() = default;
Raster::Raster(Raster&&) noexcept = default;
Raster& Raster::operator=(Raster&&) noexcept = default;
Raster::~Raster() = default;

Result<Raster, RasterProblem> Raster::open(const std::string& path, const std::string& crs,
                                           GdalSession& session) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return problem("there is no such file");
  if (!std::filesystem::is_regular_file(path, error)) return problem("this is not a file");
  Raster raster;
  raster.session_ = &session;
  raster.dataset_.reset(GDALDataset::Open(path.c_str(),
                                          GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                          gdal_drivers(), nullptr, nullptr));
  if (!raster.dataset_)
    return problem("it cannot be read as a raster" + session.complaint(),
                   "a GeoTIFF, an ESRI ASCII grid or an SRTM tile");
  if (std::strcmp(raster.dataset_->GetDriverName(), "AAIGrid") == 0)
    if (auto wrong = problem_in_ascii_grid(path)) return tl::make_unexpected(*wrong);
  if (raster.dataset_->GetRasterCount() < 1) return problem("it has no band");
  raster.columns_ = raster.dataset_->GetRasterXSize();
  raster.rows_ = raster.dataset_->GetRasterYSize();
  if (raster.columns_ < 2 || raster.rows_ < 2) return problem("it has fewer than 2 × 2 cells");
  if (auto placed = raster.find_place(crs); !placed) return tl::make_unexpected(placed.error());
  const auto middle = raster.points_at({Vector2(raster.columns_, raster.rows_) / 2})[0];
  if (!std::isfinite(middle.latitude_degrees) || !std::isfinite(middle.longitude_degrees))
    return problem("wrong projection: its middle is no place on Earth" + session.complaint(),
                   "the coordinate reference system that its coordinates are in");
  return raster;
}

Result<void, RasterProblem> Raster::find_place(const std::string& crs) {
  if (dataset_->GetGeoTransform(to_map_.data()) != CE_None ||
      GDALInvGeoTransform(to_map_.data(), to_cell_.data()) == 0 ||
      !std::all_of(to_cell_.begin(), to_cell_.end(), [](double x) { return std::isfinite(x); }))
    return problem("it does not say where its cells are" + session_->complaint());
  const auto reference = reference_of(*dataset_, crs, *session_);
  if (!reference) return tl::make_unexpected(reference.error());
  const OGRSpatialReference degrees = wgs84();
  in_degrees_ = reference->IsGeographic() != 0;
  if (in_degrees_)
    if (auto right = check_degrees(); !right) return right;
  if (reference->IsSame(&degrees) != 0) return {};
  from_wgs84_.reset(OGRCreateCoordinateTransformation(&degrees, &*reference));
  to_wgs84_.reset(OGRCreateCoordinateTransformation(&*reference, &degrees));
  if (!from_wgs84_ || !to_wgs84_)
    return problem("wrong projection: " + std::string(reference->GetName()) +
                   " cannot be related to WGS 84" + session_->complaint());
  return {};
}

Result<void, RasterProblem> Raster::check_degrees() const {
  for (const auto& [column, row] :
       {std::pair{0, 0}, std::pair{columns_, 0}, std::pair{0, rows_}, std::pair{columns_, rows_}}) {
    const double longitude = to_map_[0] + to_map_[1] * column + to_map_[2] * row;
    const double latitude = to_map_[3] + to_map_[4] * column + to_map_[5] * row;
    if (std::abs(longitude) <= 360.001 && std::abs(latitude) <= 90.001) continue;
    return problem("wrong projection: a corner at longitude " + std::to_string(longitude) +
                       ", latitude " + std::to_string(latitude),
                   "degrees, or the projection that its coordinates are in");
  }
  return {};
}

std::vector<Vector2> Raster::places_of(const std::vector<GeodeticPoint>& points) const {
  std::vector<double> x(points.size()), y(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    x[i] = points[i].longitude_degrees;
    y[i] = points[i].latitude_degrees;
  }
  std::vector<int> found(points.size(), 1);
  if (from_wgs84_)
    from_wgs84_->Transform(static_cast<int>(x.size()), x.data(), y.data(), nullptr, found.data());
  const double middle = to_map_[0] + to_map_[1] * columns_ / 2 + to_map_[2] * rows_ / 2;
  std::vector<Vector2> places(points.size(), Vector2(kNaN, kNaN));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (found[i] == 0) continue;
    // Across the date line, and for longitudes from 0 to 360.
    if (in_degrees_) x[i] += 360 * std::round((middle - x[i]) / 360);
    places[i] = {to_cell_[0] + to_cell_[1] * x[i] + to_cell_[2] * y[i] - 0.5,
                 to_cell_[3] + to_cell_[4] * x[i] + to_cell_[5] * y[i] - 0.5};
  }
  return places;
}

std::vector<GeodeticPoint> Raster::points_at(const std::vector<Vector2>& places) const {
  std::vector<double> x(places.size()), y(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double column = places[i].x() + 0.5, row = places[i].y() + 0.5;
    x[i] = to_map_[0] + to_map_[1] * column + to_map_[2] * row;
    y[i] = to_map_[3] + to_map_[4] * column + to_map_[5] * row;
  }
  std::vector<int> found(places.size(), 1);
  if (to_wgs84_)
    to_wgs84_->Transform(static_cast<int>(x.size()), x.data(), y.data(), nullptr, found.data());
  std::vector<GeodeticPoint> points(places.size(), GeodeticPoint{kNaN, kNaN, 0});
  for (std::size_t i = 0; i < places.size(); ++i)
    if (found[i] != 0 && std::abs(y[i]) <= 90.001)
      points[i] = {std::clamp(y[i], -90.0, 90.0), x[i] - 360 * std::round(x[i] / 360), 0};
  return points;
}

Result<double, RasterProblem> Raster::unit(bool lengths) const {
  const std::string name = lengths ? dataset_->GetRasterBand(1)->GetUnitType() : "";
  if (name.empty() || name == "m" || name == "metre" || name == "meter" || name == "metres" ||
      name == "meters")
    return 1.0;
  if (name == "ft" || name == "foot" || name == "feet") return 0.3048;
  if (name == "sft" || name == "us-ft" || name == "US survey foot") return 1200.0 / 3937;
  return problem("its elevations are in '" + name + "'", "metres or feet");
}

Result<std::vector<float>, RasterProblem> Raster::read(const PixelWindow& window,
                                                       bool lengths) const {
  SKEIN_EXPECTS(window.columns > 0 && window.rows > 0 && window.count() <= kMostPixels);
  const auto metres = unit(lengths);
  if (!metres) return tl::make_unexpected(metres.error());
  GDALRasterBand& band = *dataset_->GetRasterBand(1);
  const double scale = band.GetScale() * *metres, offset = band.GetOffset() * *metres;
  int has_no_data = 0;
  const double no_data = band.GetNoDataValue(&has_no_data);
  const bool masked = (band.GetMaskFlags() & (GMF_ALL_VALID | GMF_NODATA)) == 0;
  const auto columns = static_cast<std::size_t>(window.columns);
  std::vector<double> line(columns);
  std::vector<std::uint8_t> mask(columns, 255);
  std::vector<float> cells;
  cells.reserve(window.count());
  for (int row = window.row; row < window.row + window.rows; ++row) {
    CPLErr failed = band.RasterIO(GF_Read, window.column, row, window.columns, 1, line.data(),
                                  window.columns, 1, GDT_Float64, 0, 0, nullptr);
    if (failed == CE_None && masked)
      failed =
          band.GetMaskBand()->RasterIO(GF_Read, window.column, row, window.columns, 1, mask.data(),
                                       window.columns, 1, GDT_Byte, 0, 0, nullptr);
    if (failed != CE_None)
      return problem("it is damaged at row " + std::to_string(row + 1) + session_->complaint());
    for (std::size_t i = 0; i < columns; ++i) {
      const bool absent =
          !std::isfinite(line[i]) || mask[i] == 0 ||
          (has_no_data != 0 &&
           (line[i] == no_data || static_cast<float>(line[i]) == static_cast<float>(no_data)));
      cells.push_back(static_cast<float>(absent ? kNaN : line[i] * scale + offset));
    }
  }
  return cells;
}

}  // namespace skein::geodata
