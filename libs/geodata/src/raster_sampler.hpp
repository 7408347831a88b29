// SPDX-License-Identifier: Apache-2.0
// The part of a raster over a local rectangle, with values between its cells.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "raster.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/world/world_file.hpp"

namespace skein::geodata {

/// Holds the cells that a rectangle of the local frame needs, as posts; where they are too many,
/// posts of blocks of `factor` × `factor` cells, each the greatest of its block and of the eight
/// around, so that what is between posts is above all cells. Lifetime: within the raster's.
class RasterSampler {
 public:
  struct Options {
    bool lengths = false;           ///< values are metres; else more cells than posts are refused
    std::optional<double> no_data;  ///< what cells without data become
    std::size_t most_posts = kMostPixels;  ///< that are held
  };
  static Result<RasterSampler, RasterProblem> over(const Raster& raster,
                                                   const geodesy::GeodeticFrame& frame,
                                                   const world::Extent& extent,
                                                   const Options& options);

  /// Bilinear at (column, row) of the raster; NaN where a post without data has a part in it, which
  /// is noted. Up to a cell beyond the border: as at the border.
  double at(const world::Vector2& place);
  /// Cells to a post along each side.
  int factor() const { return factor_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// Of a post, as a place of the raster: (column, row), also beyond those held.
  world::Vector2 place(int column, int row) const {
    const double middle = (factor_ - 1) / 2.0;
    return {window_.column + column * factor_ + middle, window_.row + row * factor_ + middle};
  }
  /// NaN without data. Precondition: held.
  double post(int column, int row) const {
    return static_cast<double>(
        posts_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column)]);
  }
  /// Of the posts held; NaN when there are none with data.
  double lowest() const;
  /// What is to be said when at() met posts without data.
  std::optional<RasterProblem> absences() const;

 private:
  RasterSampler(const Raster& raster, const PixelWindow& window, int factor);
  Result<void, RasterProblem> read(const Options& options);
  void keep(const std::vector<float>& cells, int row);
  void take_greatest_around();
  double post(int column, int row, double weight);
  std::optional<RasterProblem> impossible(const std::vector<float>& cells, int row) const;
  std::string place_of(int column, int row) const;

  const Raster* raster_;
  PixelWindow window_;  // in cells
  int factor_, columns_, rows_;
  std::vector<float> posts_;
  std::vector<bool> absent_;  // posts without data that were needed; empty: none yet
};

}  // namespace skein::geodata
