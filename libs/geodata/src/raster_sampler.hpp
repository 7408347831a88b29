// SPDX-License-Identifier: Apache-2.0
// The part of a raster over a local rectangle, with values between its cells.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "raster.hpp"
#include "skein/geodata/geodetic_frame.hpp"
#include "skein/world/world_file.hpp"

namespace skein::geodata {

/// Holds the cells that a rectangle of the local frame needs. Lifetime: within the raster's.
class RasterSampler {
 public:
  /// `lengths`: values are metres. Cells without data become `no_data`, if given.
  static Result<RasterSampler, RasterProblem> over(const Raster& raster, const GeodeticFrame& frame,
                                                   const world::Extent& extent, bool lengths,
                                                   std::optional<double> no_data);

  /// Bilinear at (column, row) of the raster; NaN where a cell without data has a part in it, which
  /// is noted. Up to a cell beyond the border: as at the border.
  double at(const world::Vector2& place);
  /// What is held.
  const PixelWindow& window() const { return window_; }
  /// The value of one cell, by its place in the raster; NaN without data. Precondition: held.
  double post(int column, int row) const {
    return static_cast<double>(cells_[static_cast<std::size_t>(row - window_.row) *
                                          static_cast<std::size_t>(window_.columns) +
                                      static_cast<std::size_t>(column - window_.column)]);
  }
  /// Of the cells held; NaN when there are none with data.
  double lowest() const;
  /// What is to be said when at() met cells without data.
  std::optional<RasterProblem> absences() const;

 private:
  RasterSampler(const Raster& raster, const PixelWindow& window, std::vector<float> cells);
  double cell(int column, int row, double weight);
  std::optional<RasterProblem> impossible() const;
  std::string place_of(std::size_t index) const;

  const Raster* raster_;
  PixelWindow window_;
  std::vector<float> cells_;
  std::vector<bool> absent_;  // cells without data that were needed; empty: none yet
};

}  // namespace skein::geodata
