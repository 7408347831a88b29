// SPDX-License-Identifier: Apache-2.0
#include "common/ground_profile.hpp"

#include <algorithm>
#include <cmath>

namespace skein::refiners {
namespace {

using world::Vector2;

constexpr double kPlain = 1e-9;  ///< [m]

/// Fractions of a leg at which it crosses the grid lines of one axis, which begin at `low`, or the
/// border at `high`.
void add_crossings(double from, double to, double low, double high, double cell,
                   std::vector<double>& fractions) {
  if (from == to) return;
  const auto add = [&](double line) {
    const double fraction = (line - from) / (to - from);
    if (fraction > 0 && fraction < 1) fractions.push_back(fraction);
  };
  const double first = std::max(0.0, std::floor((std::min(from, to) - low) / cell));
  const double last =
      std::min(std::ceil((high - low) / cell), std::ceil((std::max(from, to) - low) / cell));
  for (double line = first; line <= last; ++line) add(low + line * cell);
  add(high);
}

}  // namespace

bool is_level(const world::Terrain& terrain) { return terrain.lowest() == terrain.highest(); }

std::vector<double> grid_crossings(const world::Terrain& terrain, const Vector2& from,
                                   const Vector2& to) {
  const world::TerrainSpec& spec = terrain.spec();
  std::vector<double> fractions = {0, 1};
  add_crossings(from.x(), to.x(), spec.west, spec.east, spec.cell, fractions);
  add_crossings(from.y(), to.y(), spec.south, spec.north, spec.cell, fractions);
  std::sort(fractions.begin(), fractions.end());
  return fractions;
}

std::vector<GroundPoint> ground_along(const world::Terrain& terrain, const Vector2& from,
                                      const Vector2& to) {
  const auto ground = [&](double part) {
    const Vector2 at = from + part * (to - from);
    return terrain.elevation(at.x(), at.y());
  };
  if (is_level(terrain)) return {{0, terrain.highest()}, {1, terrain.highest()}};
  const std::vector<double> crossings = grid_crossings(terrain, from, to);
  std::vector<GroundPoint> points = {{0, ground(0)}};
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const double begin = crossings[i - 1], end = crossings[i];
    if (!(end > begin)) continue;
    const double before = points.back().ground, after = ground(end);
    const double middle = ground((begin + end) / 2);
    // A quadratic lies under the lines through its ends and, halfway, what is as far above it there
    // as it is above its chord: so for each half where it bulges up; else under its chords.
    const double bulge = middle - (before + after) / 2;
    const double quarter = (end - begin) / 4;
    if (bulge > kPlain) points.push_back({begin + quarter, ground(begin + quarter) + bulge / 4});
    if (std::abs(bulge) > kPlain) points.push_back({begin + 2 * quarter, middle});
    if (bulge > kPlain) points.push_back({end - quarter, ground(end - quarter) + bulge / 4});
    points.push_back({end, after});
  }
  return points;
}

}  // namespace skein::refiners
