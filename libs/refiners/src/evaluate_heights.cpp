// SPDX-License-Identifier: Apache-2.0
#include "evaluate_heights.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace skein::refiners {
namespace {

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

HeightRange heights_over(const world::Terrain& terrain, const world::Vector3& from,
                         const world::Vector3& to) {
  const world::TerrainSpec& spec = terrain.spec();
  std::vector<double> fractions = {0, 1};
  add_crossings(from.x(), to.x(), spec.west, spec.east, spec.cell, fractions);
  add_crossings(from.y(), to.y(), spec.south, spec.north, spec.cell, fractions);
  std::sort(fractions.begin(), fractions.end());

  const auto height = [&](double fraction) {
    const world::Vector3 at = from + fraction * (to - from);
    return at.z() - terrain.elevation(at.x(), at.y());
  };
  HeightRange range{height(0), height(0)};
  const auto include = [&](double value) {
    range = {std::min(range.least, value), std::max(range.greatest, value)};
  };
  for (std::size_t i = 1; i < fractions.size(); ++i) {
    // Between two grid lines the height is a quadratic: h0 + b t + a t², with t from 0 to 1.
    const double begin = fractions[i - 1], size = fractions[i] - begin;
    const double h0 = height(begin), h1 = height(begin + size), middle = height(begin + size / 2);
    include(h1);
    const double a = 2 * (h0 + h1 - 2 * middle), b = h1 - h0 - a;
    const double turning = a != 0 ? -b / (2 * a) : 0;
    if (turning > 0 && turning < 1) include(h0 + (b + a * turning) * turning);
  }
  return range;
}

}  // namespace skein::refiners
