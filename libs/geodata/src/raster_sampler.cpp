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
std::vector<GeodeticPoint> border(const geodesy::GeodeticFrame& frame, const Extent& extent,
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

Result<PixelWindow, RasterProblem> window_over(const Raster& raster,
                                               const geodesy::GeodeticFrame& frame,
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
  return window;
}

int posts_over(int cells, int factor) { return (cells + factor - 1) / factor; }

/// Cells to a post so that there are no more posts.
int factor_for(const PixelWindow& window, std::size_t most_posts) {
  int factor = 1;
  while (static_cast<std::size_t>(posts_over(window.columns, factor)) *
             static_cast<std::size_t>(posts_over(window.rows, factor)) >
         most_posts)
    ++factor;
  return factor;
}

/// The greater one, or that which there is.
float greater(float a, float b) { return std::isnan(a) || b > a ? b : a; }

}  // namespace

RasterSampler::RasterSampler(const Raster& raster, const PixelWindow& window, int factor)
    : raster_(&raster),
      window_(window),
      factor_(factor),
      columns_(posts_over(window.columns, factor)),
      rows_(posts_over(window.rows, factor)) {}

Result<RasterSampler, RasterProblem> RasterSampler::over(const Raster& raster,
                                                         const geodesy::GeodeticFrame& frame,
                                                         const Extent& extent,
                                                         const Options& options) {
  const auto window = window_over(raster, frame, extent);
  if (!window) return tl::make_unexpected(window.error());
  const int factor = factor_for(*window, options.most_posts);
  if (factor > 1 && !options.lengths)
    return tl::make_unexpected(
        RasterProblem{std::to_string(window->count()) + " cells of it are too many to be held",
                      "at most " + std::to_string(options.most_posts) +
                          ": give an extent (west, south, east, north)"});
  RasterSampler sampler(raster, *window, factor);
  if (const auto read = sampler.read(options); !read) return tl::make_unexpected(read.error());
  return sampler;
}

/// By rows of posts, so that no more cells are held than those of one and the posts.
Result<void, RasterProblem> RasterSampler::read(const Options& options) {
  posts_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (int row = 0; row < window_.rows; row += factor_) {
    const PixelWindow strip{window_.column, window_.row + row, window_.columns,
                            std::min(factor_, window_.rows - row)};
    auto cells = raster_->read(strip, options.lengths);
    if (!cells) return tl::make_unexpected(cells.error());
    if (options.no_data)
      for (float& cell : *cells)
        if (std::isnan(cell)) cell = static_cast<float>(*options.no_data);
    if (options.lengths)
      if (const auto wrong = impossible(*cells, row)) return tl::make_unexpected(*wrong);
    keep(*cells, strip.rows);
  }
  if (factor_ > 1) take_greatest_around();
  return {};
}

/// One row of posts, from as many rows of cells.
void RasterSampler::keep(const std::vector<float>& cells, int rows) {
  const auto columns = static_cast<std::size_t>(window_.columns);
  const auto factor = static_cast<std::size_t>(factor_);
  for (std::size_t first = 0; first < columns; first += factor) {
    float greatest = cells[first];
    bool absent = false;
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row)
      for (std::size_t i = first; i < std::min(first + factor, columns); ++i) {
        absent = absent || std::isnan(cells[row * columns + i]);
        greatest = std::max(greatest, cells[row * columns + i]);
      }
    posts_.push_back(absent ? static_cast<float>(kNaN) : greatest);
  }
}

/// A cell lies between the posts of its own block and of blocks beside it: all are above it then.
void RasterSampler::take_greatest_around() {
  const auto along = [&](int count, int lines, std::size_t step, std::size_t line_step) {
    for (int line = 0; line < lines; ++line) {
      float* at = posts_.data() + static_cast<std::size_t>(line) * line_step;
      float before = static_cast<float>(kNaN);
      for (int i = 0; i < count; ++i, at += step) {
        const float own = *at, after = i + 1 < count ? at[step] : before;
        if (!std::isnan(own)) *at = greater(greater(own, before), after);
        before = own;
      }
    }
  };
  const auto columns = static_cast<std::size_t>(columns_);
  along(columns_, rows_, 1, columns);
  along(rows_, columns_, columns, 1);
}

std::string RasterSampler::place_of(int column, int row) const {
  const auto where = raster_->points_at({Vector2(column, row)});
  return "column " + std::to_string(column + 1) + ", row " + std::to_string(row + 1) +
         " (latitude " + text_of(where[0].latitude_degrees, 5) + ", longitude " +
         text_of(where[0].longitude_degrees, 5) + ")";
}

/// Among cells from that row of the window on.
std::optional<RasterProblem> RasterSampler::impossible(const std::vector<float>& cells,
                                                       int row) const {
  const auto wrong = std::find_if(cells.begin(), cells.end(), [](float z) {
    return z < kDeepest || z > kSummit || z == kUndeclared;
  });
  if (wrong == cells.end()) return std::nullopt;
  const auto index = static_cast<int>(wrong - cells.begin());
  char value[32];
  std::snprintf(value, sizeof value, "%g", static_cast<double>(*wrong));
  return RasterProblem{std::string("an elevation of ") + value + " m in " +
                           place_of(window_.column + index % window_.columns,
                                    window_.row + row + index / window_.columns),
                       "ground between -12 km and 10 km; what stands for no data must be declared "
                       "in the file"};
}

/// Posts without weight have no part in it: on a post its neighbours do not count.
double RasterSampler::post(int column, int row, double weight) {
  if (weight == 0) return 0;
  const double value = post(column, row);
  if (std::isnan(value)) {
    absent_.resize(posts_.size());
    absent_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(column)] = true;
  }
  return weight * value;
}

double RasterSampler::at(const Vector2& place) {
  if (!place.allFinite()) return kNaN;
  const Vector2 from_first = (place - this->place(0, 0)) / factor_;
  const double u = std::clamp(from_first.x(), 0.0, columns_ - 1.0);
  const double v = std::clamp(from_first.y(), 0.0, rows_ - 1.0);
  const int column = std::min(static_cast<int>(u), std::max(0, columns_ - 2));
  const int row = std::min(static_cast<int>(v), std::max(0, rows_ - 2));
  const double east = u - column, south = v - row;
  return post(column, row, (1 - east) * (1 - south)) + post(column + 1, row, east * (1 - south)) +
         post(column, row + 1, (1 - east) * south) + post(column + 1, row + 1, east * south);
}

double RasterSampler::lowest() const {
  double lowest = kNaN;
  for (const float value : posts_)
    if (!std::isnan(value) && !(static_cast<double>(value) >= lowest))
      lowest = static_cast<double>(value);
  return lowest;
}

std::optional<RasterProblem> RasterSampler::absences() const {
  const auto count = std::count(absent_.begin(), absent_.end(), true);
  if (count == 0) return std::nullopt;
  const auto first =
      static_cast<int>(std::find(absent_.begin(), absent_.end(), true) - absent_.begin());
  const std::string what = factor_ > 1 ? " block of cells" : " cell";
  return RasterProblem{std::to_string(count) + what + (count == 1 ? "" : "s") +
                           " without data where ground is wanted, the first in " +
                           place_of(window_.column + first % columns_ * factor_,
                                    window_.row + first / columns_ * factor_),
                       "a value for them (nodata: NUMBER), or an extent without them"};
}

}  // namespace skein::geodata
