// SPDX-License-Identifier: Apache-2.0
#include "map/relief.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::report {

using drawing::Colour;

namespace {

constexpr std::size_t kTints = 8;
constexpr std::size_t kShades = 32;
constexpr double kSteepestShown = 0.9;
constexpr double kMostExaggeration = 6.0;
constexpr std::size_t kMostContourCells = 200;

// From meadow to bare rock, pale enough to draw on.
constexpr std::array<Colour, kTints> kTintColours{{{214, 226, 202},
                                                   {221, 230, 203},
                                                   {229, 233, 205},
                                                   {236, 234, 207},
                                                   {239, 230, 206},
                                                   {238, 224, 205},
                                                   {238, 222, 212},
                                                   {242, 236, 231}}};

// Of a few steps, as of a printed map.
Colour colour_of(double rise, double light) {
  const auto tint = std::min(kTints - 1, static_cast<std::size_t>(rise * kTints));
  const auto shade = std::min(kShades - 1, static_cast<std::size_t>(light * kShades));
  const double lit = 0.55 + 0.52 * static_cast<double>(shade) / (kShades - 1);
  const auto scaled = [lit](std::uint8_t c) {
    return static_cast<std::uint8_t>(std::min(255.0, c * lit));
  };
  const Colour& ground = kTintColours[tint];
  return {scaled(ground.red), scaled(ground.green), scaled(ground.blue)};
}

// Reads fields of the grid's size between the nodes.
class Sampler {
 public:
  explicit Sampler(const TerrainGrid& grid) : grid_(grid) {}

  double operator()(const std::vector<double>& field, double x, double y) const {
    const double u = index(x - grid_.west, grid_.width), v = index(y - grid_.south, grid_.height);
    const auto column = std::min(static_cast<std::size_t>(u), grid_.width - 2);
    const auto row = std::min(static_cast<std::size_t>(v), grid_.height - 2);
    const double du = u - static_cast<double>(column), dv = v - static_cast<double>(row);
    const double* south = field.data() + row * grid_.width + column;
    const double* north = south + grid_.width;
    return (south[0] * (1 - du) + south[1] * du) * (1 - dv) +
           (north[0] * (1 - du) + north[1] * du) * dv;
  }

 private:
  double index(double offset, std::size_t size) const {
    return std::clamp(offset / grid_.cell, 0.0, static_cast<double>(size - 1));
  }

  const TerrainGrid& grid_;
};

// Slopes at the nodes by central differences, one-sided at the edges.
struct Slopes {
  std::vector<double> east, north;
  double steepest = 0.0;
};

Slopes slopes_of(const TerrainGrid& g) {
  Slopes s{std::vector<double>(g.values.size()), std::vector<double>(g.values.size()), 0.0};
  for (std::size_t row = 0; row < g.height; ++row) {
    for (std::size_t column = 0; column < g.width; ++column) {
      const std::size_t w = column > 0 ? column - 1 : 0, e = std::min(column + 1, g.width - 1);
      const std::size_t so = row > 0 ? row - 1 : 0, no = std::min(row + 1, g.height - 1);
      const std::size_t i = row * g.width + column;
      s.east[i] = (g.values[row * g.width + e] - g.values[row * g.width + w]) /
                  (g.cell * static_cast<double>(e - w));
      s.north[i] = (g.values[no * g.width + column] - g.values[so * g.width + column]) /
                   (g.cell * static_cast<double>(no - so));
      s.steepest = std::max(s.steepest, std::hypot(s.east[i], s.north[i]));
    }
  }
  return s;
}

double light_of(double slope_east, double slope_north) {
  // The light comes from azimuth 315°, 45° above the horizon.
  const double norm = std::sqrt(1.0 + slope_east * slope_east + slope_north * slope_north);
  return std::max(0.0, (0.5 * slope_east - 0.5 * slope_north + M_SQRT1_2) / norm);
}

TerrainGrid thinned(const TerrainGrid& g) {
  const std::size_t stride = (std::max(g.width, g.height) - 1) / kMostContourCells + 1;
  TerrainGrid t{g.west, g.south, g.cell * static_cast<double>(stride), 0, 0, {}};
  t.width = (g.width - 1) / stride + 1;
  t.height = (g.height - 1) / stride + 1;
  for (std::size_t row = 0; row < t.height; ++row) {
    for (std::size_t column = 0; column < t.width; ++column) {
      t.values.push_back(g.values[row * stride * g.width + column * stride]);
    }
  }
  return t;
}

using Segment = std::pair<GroundPoint, GroundPoint>;

// Where the level crosses the sides of one cell: none, two or four points, joined in pairs.
void cross_cell(const TerrainGrid& g, std::size_t column, std::size_t row, double level,
                std::vector<Segment>& segments) {
  constexpr std::array<std::array<std::size_t, 2>, 4> kCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::array<GroundPoint, 4> crossings{};
  std::size_t count = 0;
  for (std::size_t side = 0; side < 4; ++side) {
    const auto& a = kCorners[side];
    const auto& b = kCorners[(side + 1) % 4];
    const double ha = g.values[(row + a[1]) * g.width + column + a[0]];
    const double hb = g.values[(row + b[1]) * g.width + column + b[0]];
    if ((ha < level) == (hb < level)) continue;
    const double part = (level - ha) / (hb - ha);
    const auto mix = [part](std::size_t from, std::size_t to) {
      return static_cast<double>(from) +
             (static_cast<double>(to) - static_cast<double>(from)) * part;
    };
    crossings[count++] = {g.west + g.cell * (static_cast<double>(column) + mix(a[0], b[0])),
                          g.south + g.cell * (static_cast<double>(row) + mix(a[1], b[1]))};
  }
  for (std::size_t i = 0; i + 1 < count; i += 2) {
    segments.emplace_back(crossings[i], crossings[i + 1]);
  }
}

}  // namespace

bool is_usable(const TerrainGrid& g) {
  return g.width >= 2 && g.height >= 2 && g.cell > 0 && g.values.size() / g.width == g.height &&
         g.values.size() % g.width == 0 &&
         std::all_of(g.values.begin(), g.values.end(), [](double v) { return std::isfinite(v); });
}

drawing::Pixels shaded_relief(const TerrainGrid& grid, const Extents& view, std::size_t width,
                              std::size_t height) {
  SKEIN_EXPECTS(is_usable(grid) && width > 0 && height > 0);
  const Slopes slopes = slopes_of(grid);
  const double exaggeration =
      slopes.steepest > 0 ? std::clamp(kSteepestShown / slopes.steepest, 1.0, kMostExaggeration)
                          : 1;
  const auto [lowest, highest] = std::minmax_element(grid.values.begin(), grid.values.end());
  const double range = std::max(*highest - *lowest, 1e-6);
  const Sampler sample(grid);
  drawing::Pixels image(width, height);
  for (std::size_t row = 0; row < height; ++row) {
    const double y = view.north - (view.north - view.south) * (static_cast<double>(row) + 0.5) /
                                      static_cast<double>(height);
    for (std::size_t column = 0; column < width; ++column) {
      const double x = view.west + (view.east - view.west) * (static_cast<double>(column) + 0.5) /
                                       static_cast<double>(width);
      const double rise = (sample(grid.values, x, y) - *lowest) / range;
      const double light = light_of(exaggeration * sample(slopes.east, x, y),
                                    exaggeration * sample(slopes.north, x, y));
      image.set(column, row, colour_of(rise, light));
    }
  }
  return image;
}

std::vector<Contour> contours(const TerrainGrid& full) {
  const TerrainGrid g = thinned(full);
  std::vector<Contour> result;
  if (g.width < 2 || g.height < 2) return result;
  const auto [lowest, highest] = std::minmax_element(g.values.begin(), g.values.end());
  if (*highest - *lowest < 0.5) return result;
  const double step = round_step((*highest - *lowest) / 8.0);
  for (const double level : ticks(*lowest, *highest, step)) {
    Contour contour{level, {}};
    for (std::size_t row = 0; row + 1 < g.height; ++row) {
      for (std::size_t column = 0; column + 1 < g.width; ++column) {
        cross_cell(g, column, row, level, contour.segments);
      }
    }
    if (!contour.segments.empty()) result.push_back(std::move(contour));
  }
  return result;
}

}  // namespace skein::report
