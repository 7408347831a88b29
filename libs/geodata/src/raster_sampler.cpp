// SPDX-License-Identifier: Apache-2.0
#include "raster_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace skein::geodata {

using world::Extent;
using world::GeodeticPoint;
using world::Vector2;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
/// Ground is looked for between these [m].
constexpr double kLowest = -500, kHighest = 9000;
/// No ground, not even under water, is lower or higher [m].
constexpr float kDeepest = -12'000, kSummit = 10'000;
/// What most files write where there are no data, declared or not.
constexpr float kUndeclared = -9999;

/// Points along the border of a rectangle, as they are on Earth at some altitude.
std::vector<GeodeticPoint> border(const GeodeticFrame& frame, const Extent& extent,
                                  double altitude) {
  constexpr int kSteps = 64;
  const double z = altitude - frame.origin().altitude;
  std::vector<GeodeticPoint> points;
  for (int i = 0; i < kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    const double x = extent.west + t * (extent.east - extent.west);
    const double y = extent.south + t * (extent.north - extent.south);
    for (const auto& [px, py] : {std::pair{x, extent.south}, std::pair{extent.east, y},
                                 std::pair{extent.west + extent.east - x, extent.north},
                                 std::pair{extent.west, extent.south + extent.north - y}})
      points.push_back(frame.to_geodetic({px, py, z}));
  }
  return points;
}

std::string text_of(double x, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, x);
  return text;
}

/// Covers every border given.
struct Bounds {
  Vector2 low = Vector2::Constant(std::numeric_limits<double>::infinity());
  Vector2 high = Vector2::Constant(-std::numeric_limits<double>::infinity());
  std::optional<std::size_t> outside;  ///< the first place that is off the raster

  void add(const std::vector<Vector2>& places, const Raster& raster) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Vector2& place = places[i];
      const bool inside = place.x() >= -1 && place.y() >= -1 && place.x() <= raster.columns() &&
                          place.y() <= raster.rows();
      if (!inside && !outside) outside = i;
      if (!place.allFinite()) continue;
      low = low.cwiseMin(place);
      high = high.cwiseMax(place);
    }
  }
};

Result<PixelWindow, RasterProblem> window_over(const Raster& raster, const GeodeticFrame& frame,
                                               const Extent& extent) {
  Bounds bounds;
  const auto level = border(frame, extent, frame.origin().altitude);
  bounds.add(raster.places_of(level), raster);
  if (bounds.outside) {
    const GeodeticPoint& where = level[*bounds.outside];
    return tl::make_unexpected(
        RasterProblem{"the ground that is wanted reaches beyond it, at latitude " +
                          text_of(where.latitude_degrees, 5) + ", longitude " +
                          text_of(where.longitude_degrees, 5),
                      "an origin and an extent within the raster"});
  }
  for (const double altitude : {kLowest, kHighest})
    bounds.add(raster.places_of(border(frame, extent, altitude)), raster);
  const Vector2 margin = Vector2::Constant(2) + (bounds.high - bounds.low) * 0.01;
  const auto clamped = [](double place, int count) {
    return static_cast<int>(std::clamp(std::floor(place), 0.0, static_cast<double>(count - 1)));
  };
  PixelWindow window;
  window.column = clamped(bounds.low.x() - margin.x(), raster.columns());
  window.row = clamped(bounds.low.y() - margin.y(), raster.rows());
  window.columns = clamped(bounds.high.x() + margin.x() + 1, raster.columns()) - window.column + 1;
  window.rows = clamped(bounds.high.y() + margin.y() + 1, raster.rows()) - window.row + 1;
  if (window.count() > kMostPixels)
    return tl::make_unexpected(
        RasterProblem{std::to_string(window.count()) + " cells of it are too many to be held",
                      "at most 32 million: give an extent (west, south, east, north)"});
  return window;
}

}  // namespace

RasterSampler::RasterSampler(const Raster& raster, const PixelWindow& window,
                             std::vector<float> cells)
    : raster_(&raster), window_(window), cells_(std::move(cells)) {}

Result<RasterSampler, RasterProblem> RasterSampler::over(const Raster& raster,
                                                         const GeodeticFrame& frame,
                                                         const Extent& extent, bool lengths,
                                                         std::optional<double> no_data) {
  const auto window = window_over(raster, frame, extent);
  if (!window) return tl::make_unexpected(window.error());
  auto cells = raster.read(*window, lengths);
  if (!cells) return tl::make_unexpected(cells.error());
  if (no_data)
    for (float& cell : *cells)
      if (std::isnan(cell)) cell = static_cast<float>(*no_data);
  RasterSampler sampler(raster, *window, std::move(*cells));
  if (lengths)
    if (const auto wrong = sampler.impossible()) return tl::make_unexpected(*wrong);
  return sampler;
}

std::string RasterSampler::place_of(std::size_t index) const {
  const auto columns = static_cast<std::size_t>(window_.columns);
  const int column = window_.column + static_cast<int>(index % columns);
  const int row = window_.row + static_cast<int>(index / columns);
  const auto where = raster_->points_at({Vector2(column, row)});
  return "column " + std::to_string(column + 1) + ", row " + std::to_string(row + 1) +
         " (latitude " + text_of(where[0].latitude_degrees, 5) + ", longitude " +
         text_of(where[0].longitude_degrees, 5) + ")";
}

std::optional<RasterProblem> RasterSampler::impossible() const {
  const auto wrong = std::find_if(cells_.begin(), cells_.end(), [](float z) {
    return z < kDeepest || z > kSummit || z == kUndeclared;
  });
  if (wrong == cells_.end()) return std::nullopt;
  char value[32];
  std::snprintf(value, sizeof value, "%g", static_cast<double>(*wrong));
  return RasterProblem{std::string("an elevation of ") + value + " m in " +
                           place_of(static_cast<std::size_t>(wrong - cells_.begin())),
                       "ground between -12 km and 10 km; what stands for no data must be declared "
                       "in the file"};
}

/// Cells without weight have no part in it: on the middle of a cell its neighbours do not count.
double RasterSampler::cell(int column, int row, double weight) {
  if (weight == 0) return 0;
  const std::size_t index =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(window_.columns) +
      static_cast<std::size_t>(column);
  const float value = cells_[index];
  if (std::isnan(value)) {
    absent_.resize(cells_.size());
    absent_[index] = true;
  }
  return weight * static_cast<double>(value);
}

double RasterSampler::at(const Vector2& place) {
  if (!place.allFinite()) return kNaN;
  const double u = std::clamp(place.x() - window_.column, 0.0, window_.columns - 1.0);
  const double v = std::clamp(place.y() - window_.row, 0.0, window_.rows - 1.0);
  const int column = std::min(static_cast<int>(u), std::max(0, window_.columns - 2));
  const int row = std::min(static_cast<int>(v), std::max(0, window_.rows - 2));
  const double east = u - column, south = v - row;
  return cell(column, row, (1 - east) * (1 - south)) + cell(column + 1, row, east * (1 - south)) +
         cell(column, row + 1, (1 - east) * south) + cell(column + 1, row + 1, east * south);
}

double RasterSampler::lowest() const {
  double lowest = kNaN;
  for (const float value : cells_)
    if (!std::isnan(value) && !(static_cast<double>(value) >= lowest))
      lowest = static_cast<double>(value);
  return lowest;
}

std::optional<RasterProblem> RasterSampler::absences() const {
  const auto count = std::count(absent_.begin(), absent_.end(), true);
  if (count == 0) return std::nullopt;
  const auto first = std::find(absent_.begin(), absent_.end(), true) - absent_.begin();
  return RasterProblem{std::to_string(count) + (count == 1 ? " cell" : " cells") +
                           " without data where ground is wanted, the first in " +
                           place_of(static_cast<std::size_t>(first)),
                       "a value for them (nodata: NUMBER), or an extent without them"};
}

}  // namespace skein::geodata
