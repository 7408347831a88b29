// SPDX-License-Identifier: Apache-2.0
#include "ground_layer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "palette.hpp"

namespace skein::cartography {
namespace {

using world::Vector2;

/// Pixels of the picture for one of the shading, which is smoothed when shown.
constexpr double kShadeStep = 2;
/// Cells along the longer side in which contour lines are traced.
constexpr double kContourCells = 160;
/// The ground is shown at most this much steeper than it is, so that gentle hills show too.
constexpr double kMostExaggeration = 8;

std::size_t count(double length) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(length)));
}

/// How much of the light falls on ground that rises so east and north.
double light_on(double east, double north) {
  constexpr double sun_height = std::numbers::pi / 4;
  const double norm = std::sqrt(1 + east * east + north * north);
  const double towards = (east - north) / std::numbers::sqrt2;  // the sun is in the north-west
  return std::max(0.0, (std::sin(sun_height) + std::cos(sun_height) * towards) / norm);
}

/// Elevations on a lattice over the frame.
class Lattice {
 public:
  Lattice(const world::Terrain& terrain, const Frame& frame, double step)
      : frame_(frame),
        columns_(count((frame.east - frame.west) / step) + 1),
        rows_(count((frame.north - frame.south) / step) + 1) {
    for (std::size_t row = 0; row < rows_; ++row)
      for (std::size_t column = 0; column < columns_; ++column) {
        const Vector2 at = place(column, row);
        heights_.push_back(terrain.elevation(at.x(), at.y()));
      }
  }
  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  double height(std::size_t column, std::size_t row) const {
    return heights_[row * columns_ + column];
  }
  Vector2 place(std::size_t column, std::size_t row) const {
    const auto part = [](std::size_t i, std::size_t n) {
      return static_cast<double>(i) / static_cast<double>(n - 1);
    };
    return {frame_.west + part(column, columns_) * (frame_.east - frame_.west),
            frame_.south + part(row, rows_) * (frame_.north - frame_.south)};
  }

 private:
  Frame frame_;
  std::size_t columns_, rows_;
  std::vector<double> heights_;
};

/// The pieces of one contour line within one cell of the lattice (marching squares).
void trace_cell(const Lattice& lattice, std::size_t column, std::size_t row, double level,
                std::vector<std::pair<Vector2, Vector2>>& pieces) {
  const std::array<std::pair<std::size_t, std::size_t>, 4> corners = {
      {{column, row}, {column + 1, row}, {column + 1, row + 1}, {column, row + 1}}};
  std::vector<Vector2> crossings;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [ac, ar] = corners[i];
    const auto [bc, br] = corners[(i + 1) % 4];
    const double a = lattice.height(ac, ar), b = lattice.height(bc, br);
    if ((a < level) == (b < level)) continue;
    const Vector2 from = lattice.place(ac, ar), to = lattice.place(bc, br);
    crossings.emplace_back(from + (level - a) / (b - a) * (to - from));
  }
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    pieces.emplace_back(crossings[i], crossings[i + 1]);
}

std::string contour(const Lattice& lattice, const Scale& scale, double level) {
  std::vector<std::pair<Vector2, Vector2>> pieces;
  for (std::size_t row = 0; row + 1 < lattice.rows(); ++row)
    for (std::size_t column = 0; column + 1 < lattice.columns(); ++column)
      trace_cell(lattice, column, row, level, pieces);
  std::string path;
  for (const auto& [from, to] : pieces) {
    const Spot a = scale(from), b = scale(to);
    path += "M" + px(a.x) + " " + px(a.y) + "L" + px(b.x) + " " + px(b.y);
  }
  return path;
}

}  // namespace

Scale::Scale(const Frame& frame, double most_width, double most_height)
    : frame_(frame),
      per_metre_(std::min(most_width / (frame.east - frame.west),
                          most_height / (frame.north - frame.south))) {}

Relief relief_of(const world::Terrain& terrain, const Frame& frame) {
  const Lattice lattice(terrain, frame,
                        std::max(frame.east - frame.west, frame.north - frame.south) / 200);
  Relief relief{lattice.height(0, 0), lattice.height(0, 0)};
  for (std::size_t row = 0; row < lattice.rows(); ++row)
    for (std::size_t column = 0; column < lattice.columns(); ++column) {
      relief.low = std::min(relief.low, lattice.height(column, row));
      relief.high = std::max(relief.high, lattice.height(column, row));
    }
  return relief;
}

Pixels hill_shade(const world::Terrain& terrain, const Scale& scale, const Relief& relief) {
  const Frame& frame = scale.frame();
  Pixels pixels(count(scale.width() / kShadeStep), count(scale.height() / kShadeStep));
  const double step_x = (frame.east - frame.west) / static_cast<double>(pixels.width());
  const double step_y = (frame.north - frame.south) / static_cast<double>(pixels.height());
  const double span = std::max(relief.high - relief.low, 1e-9);
  const double steepness = std::min(
      kMostExaggeration, std::max(1.0, 0.25 * (frame.east - frame.west) / std::max(span, 1.0)));
  for (std::size_t row = 0; row < pixels.height(); ++row)
    for (std::size_t column = 0; column < pixels.width(); ++column) {
      const double x = frame.west + (static_cast<double>(column) + 0.5) * step_x;
      const double y = frame.north - (static_cast<double>(row) + 0.5) * step_y;
      const double east =
          (terrain.elevation(x + step_x, y) - terrain.elevation(x - step_x, y)) / (2 * step_x);
      const double north =
          (terrain.elevation(x, y + step_y) - terrain.elevation(x, y - step_y)) / (2 * step_y);
      const double height = (terrain.elevation(x, y) - relief.low) / span;
      pixels.set(column, row,
                 ground_tint(span > 1 ? height : 0.2,
                             light_on(east * steepness / 4, north * steepness / 4)));
    }
  return pixels;
}

double contour_interval(const Relief& relief) {
  const double wanted = std::max(relief.high - relief.low, 1.0) / 10;
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= wanted * 0.999) return factor * power;
  return 10 * power;
}

std::string contours(const world::Terrain& terrain, const Scale& scale, const Relief& relief) {
  if (is_level(relief)) return {};
  const Frame& frame = scale.frame();
  const double longer = std::max(frame.east - frame.west, frame.north - frame.south);
  const Lattice lattice(terrain, frame, longer / kContourCells);
  const double interval = contour_interval(relief);
  std::string out;
  for (double index = std::floor(relief.low / interval) + 1; index * interval < relief.high;
       ++index) {
    const bool strong = std::abs(std::remainder(index, 5)) < 0.5;
    out += fmt::format(
        R"(<path d="{}" fill="none" stroke="#7a5c3a" stroke-width="{}" stroke-opacity="{}"/>)"
        "\n",
        contour(lattice, scale, index * interval), strong ? "0.9" : "0.5", strong ? "0.5" : "0.35");
  }
  return out;
}

}  // namespace skein::cartography
