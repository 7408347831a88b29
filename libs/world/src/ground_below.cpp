// SPDX-License-Identifier: Apache-2.0
#include "ground_below.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skein::world {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
/// About what an elevation takes [ns].
constexpr std::size_t kElevation = 8;

/// The two ends of [from, until], held within [low, high], and the lines of a grid in between: the
/// places where a surface that is linear between those lines can be highest.
std::vector<double> corners_along(double from, double until, double low, double high, double cell) {
  const double a = std::clamp(from, low, high), b = std::clamp(until, low, high);
  std::vector<double> corners = {a};
  const auto first = static_cast<std::int64_t>(std::floor((a - low) / cell));
  const auto last = static_cast<std::int64_t>(std::ceil((b - low) / cell));
  for (std::int64_t i = first; i <= last; ++i) {
    const double line = low + static_cast<double>(i) * cell;
    if (line > a && line < b) corners.push_back(line);
  }
  if (b > a) corners.push_back(b);
  return corners;
}

/// How voxels and the terrain's cells lie along one axis.
struct Axis {
  double origin, voxel, margin;
  double low, high, cell;  // of the terrain
};

/// Which corners of the terrain's cells lie in each of the rows (or columns) of voxels.
std::vector<std::vector<double>> corners_of_voxels(const Axis& axis, std::int32_t first,
                                                   std::int32_t count) {
  std::vector<std::vector<double>> corners;
  corners.reserve(static_cast<std::size_t>(count));
  for (std::int32_t i = first; i < first + count; ++i) {
    const double from = axis.origin + i * axis.voxel;
    corners.push_back(corners_along(from - axis.margin, from + axis.voxel + axis.margin, axis.low,
                                    axis.high, axis.cell));
  }
  return corners;
}

template <class Corners>
Corners each_once(const std::vector<std::vector<double>>& of_voxels) {
  Corners corners;
  for (const std::vector<double>& places : of_voxels)
    corners.places.insert(corners.places.end(), places.begin(), places.end());
  std::sort(corners.places.begin(), corners.places.end());
  corners.places.erase(std::unique(corners.places.begin(), corners.places.end()),
                       corners.places.end());
  const auto index_of = [&](double place) {
    const auto found = std::lower_bound(corners.places.begin(), corners.places.end(), place);
    return static_cast<std::size_t>(found - corners.places.begin());
  };
  // What else lies between the first and the last of a voxel is below the surface of these.
  for (const std::vector<double>& places : of_voxels)
    corners.of_voxels.emplace_back(index_of(places.front()), index_of(places.back()) + 1);
  return corners;
}

Ground joined(const Ground& a, const Ground& b) {
  return {std::min(a.lowest, b.lowest), std::max(a.highest, b.highest)};
}

}  // namespace

GroundBelow::Corners GroundBelow::corners_of_columns(std::int32_t first, std::int32_t count) const {
  const TerrainSpec& spec = terrain_.spec();
  const Axis axis = {grid_.origin.x(), grid_.voxel, margin_, spec.west, spec.east, spec.cell};
  return each_once<Corners>(corners_of_voxels(axis, first, count));
}

GroundBelow::Corners GroundBelow::corners_of_rows(std::int32_t first, std::int32_t count) const {
  const TerrainSpec& spec = terrain_.spec();
  const Axis axis = {grid_.origin.y(), grid_.voxel, margin_, spec.south, spec.north, spec.cell};
  return each_once<Corners>(corners_of_voxels(axis, first, count));
}

/// What is under each column along a line from west to east.
void GroundBelow::follow_line(double y) {
  for (std::size_t i = 0; i < heights_.size(); ++i)
    heights_[i] = terrain_.elevation(xs_.places[i], y);
  for (std::size_t i = 0; i < line_.size(); ++i) {
    const auto [first, end] = xs_.of_voxels[i];
    line_[i] = {kFar, -kFar};
    for (std::size_t at = first; at < end; ++at)
      line_[i] = joined(line_[i], {heights_[at], heights_[at]});
  }
}

const std::vector<Ground>& GroundBelow::of(const ColumnTile& tile, WorkClock& clock) {
  const auto columns = static_cast<std::size_t>(tile.columns);
  if (first_column_ != tile.x || line_.size() != columns) {
    xs_ = corners_of_columns(tile.x, tile.columns);
    first_column_ = tile.x;
    heights_.resize(xs_.places.size());
    line_.resize(columns);
  }
  const Corners ys = corners_of_rows(tile.y, tile.rows);
  grounds_.assign(tile.count(), Ground{kFar, -kFar});
  std::size_t first_row = 0;
  for (std::size_t k = 0; k < ys.places.size(); ++k) {
    if (clock.is_up_after(kElevation * heights_.size())) return grounds_;
    follow_line(ys.places[k]);
    while (first_row < ys.of_voxels.size() && ys.of_voxels[first_row].second <= k) ++first_row;
    for (std::size_t row = first_row; row < ys.of_voxels.size() && ys.of_voxels[row].first <= k;
         ++row)
      for (std::size_t i = 0; i < columns; ++i)
        grounds_[row * columns + i] = joined(grounds_[row * columns + i], line_[i]);
  }
  return grounds_;
}

}  // namespace skein::world
