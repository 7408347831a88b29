// SPDX-License-Identifier: Apache-2.0
#include "skein/world/horizon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "skein/foundation/contract.hpp"

namespace skein::world {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();

/// The part of [low, high] in which start + t × step lies within [least, most].
void clip(double start, double step, double least, double most, double& low, double& high) {
  if (step == 0) {
    if (start < least || start > most) high = low - 1;
    return;
  }
  const double a = (least - start) / step, b = (most - start) / step;
  low = std::max(low, std::min(a, b));
  high = std::min(high, std::max(a, b));
}

/// Where start + t × step crosses lines of the grid, t in (low, high).
void add_crossings(double start, double step, double low, double high, std::vector<double>& at) {
  if (step == 0) return;
  const double first = start + low * step, last = start + high * step;
  const double end = std::floor(std::max(first, last));
  for (double line = std::ceil(std::min(first, last)); line <= end; line += 1)
    if (const double t = (line - start) / step; t > low && t < high) at.push_back(t);
}

/// Distances between which the way is over one cell, both ends of the ground under it among them.
std::vector<double> cuts(const TerrainSpec& spec, const Vector3& from, const Vector2& along,
                         double reach) {
  double low = 0, high = reach;
  clip(from.x(), along.x(), spec.west, spec.east, low, high);
  clip(from.y(), along.y(), spec.south, spec.north, low, high);
  if (!(low < high)) return {};
  std::vector<double> at = {low, high};
  add_crossings((from.x() - spec.west) / spec.cell, along.x() / spec.cell, low, high, at);
  add_crossings((from.y() - spec.south) / spec.cell, along.y() / spec.cell, low, high, at);
  std::sort(at.begin(), at.end());
  return at;
}

}  // namespace

HorizonProfile::HorizonProfile(const Terrain& terrain, const Vector3& from, double azimuth,
                               double reach)
    : height_(from.z()) {
  SKEIN_EXPECTS(from.allFinite() && std::isfinite(azimuth) && std::isfinite(reach) && reach >= 0);
  const Vector2 along(std::cos(azimuth), std::sin(azimuth));
  const auto ground = [&](double t) {
    return terrain.elevation(from.x() + t * along.x(), from.y() + t * along.y()) - height_;
  };
  const std::vector<double> at = cuts(terrain.spec(), from, along, reach);
  double steepest = kNever;
  double begin_height = at.empty() ? 0 : ground(at.front());
  pieces_.reserve(at.size());
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const double begin = at[i], length = at[i + 1] - begin;
    if (!(length > 0)) continue;
    const double end_height = ground(at[i + 1]);
    const double sag = begin_height + end_height - 2 * ground(begin + length / 2);
    const double bend = 2 * sag / (length * length);
    const double slope = (end_height - begin_height) / length - bend * length;
    pieces_.push_back({begin, at[i + 1], begin_height, slope, bend, steepest});
    begin_height = end_height;
    steepest = std::max(steepest, pieces_.back().steepest_until(at[i + 1]));
  }
}

double HorizonProfile::Piece::slope_to(double distance) const {
  const double beyond = distance - begin;
  const double over = height + (slope + bend * beyond) * beyond;
  if (distance > 0) return over / distance;
  return over > 0 ? -kNever : kNever;
}

double HorizonProfile::Piece::steepest_until(double distance) const {
  double steepest = std::max(slope_to(begin), slope_to(distance));
  // Its slope seen from the origin is that of bend t + … + c / t, with c what it would be there.
  const double c = height - (slope - bend * begin) * begin;
  if (c < 0 && bend < 0)
    if (const double top = std::sqrt(c / bend); top > begin && top < distance)
      steepest = std::max(steepest, slope_to(top));
  return steepest;
}

double HorizonProfile::slope_until(double distance) const {
  const auto after = std::partition_point(
      pieces_.begin(), pieces_.end(), [&](const Piece& piece) { return piece.begin < distance; });
  if (after == pieces_.begin()) return kNever;
  const Piece& piece = *(after - 1);
  return std::max(piece.steepest_before, piece.steepest_until(std::min(distance, piece.end)));
}

}  // namespace skein::world
