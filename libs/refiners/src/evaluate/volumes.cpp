// SPDX-License-Identifier: Apache-2.0
#include "evaluate/volumes.hpp"

#include <algorithm>
#include <utility>

namespace skein::refiners {
namespace {

using world::Vector2;

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Where along the leg its height is within the band; from > until: nowhere.
LegPart within_band(const world::Volume& volume, double from, double to) {
  if (from == to) {
    const bool inside = from > volume.floor && from < volume.ceiling;
    return inside ? LegPart{0, 1} : LegPart{1, 0};
  }
  const double a = (volume.floor - from) / (to - from), b = (volume.ceiling - from) / (to - from);
  return {std::max(0.0, std::min(a, b)), std::min(1.0, std::max(a, b))};
}

void add_crossing(const Vector2& from, const Vector2& step, const Vector2& corner,
                  const Vector2& edge, std::vector<double>& fractions) {
  const double turn = cross(step, edge);
  if (turn != 0) {
    const double along = cross(corner - from, edge) / turn;
    fractions.push_back(along);
    return;
  }
  // Along the edge or beside it: where it passes the corners.
  const double length2 = step.squaredNorm();
  if (length2 == 0) return;
  fractions.push_back((corner - from).dot(step) / length2);
  fractions.push_back((corner + edge - from).dot(step) / length2);
}

}  // namespace

std::vector<LegPart> parts_inside(const world::Volume& volume, const world::Vector3& from,
                                  const world::Vector3& to) {
  const LegPart band = within_band(volume, from.z(), to.z());
  if (!(band.from < band.until)) return {};
  const Vector2 start = from.head<2>(), step = to.head<2>() - start;
  std::vector<double> fractions = {band.from, band.until};
  for (std::size_t i = 0; i < volume.polygon.size(); ++i) {
    const Vector2& corner = volume.polygon[i];
    const Vector2 edge = volume.polygon[(i + 1) % volume.polygon.size()] - corner;
    add_crossing(start, step, corner, edge, fractions);
  }
  std::erase_if(fractions, [&](double f) { return !(f >= band.from && f <= band.until); });
  std::sort(fractions.begin(), fractions.end());

  // Between two neighbours the leg is inside or outside altogether.
  std::vector<LegPart> parts;
  for (std::size_t i = 1; i < fractions.size(); ++i) {
    if (!(fractions[i - 1] < fractions[i])) continue;
    const double middle = (fractions[i - 1] + fractions[i]) / 2;
    if (!world::contains(volume.polygon, start + middle * step)) continue;
    if (!parts.empty() && parts.back().until == fractions[i - 1])
      parts.back().until = fractions[i];
    else
      parts.push_back({fractions[i - 1], fractions[i]});
  }
  return parts;
}

std::optional<double> first_within(const LegPart& part, const LegTimes& times,
                                   const world::TimeWindow& window) {
  const auto after = [](MissionTime begin, Duration whole, double fraction) {
    if (whole == Duration::max() && fraction > 0) return MissionTime::max();
    return begin + Duration::seconds(whole.to_seconds() * fraction);
  };
  double first = part.from;
  if (after(times.latest, times.most, part.from) < window.from) {
    if (after(times.latest, times.most, part.until) < window.from) return std::nullopt;
    if (times.most != Duration::max())
      first = std::clamp((window.from - times.latest).to_seconds() / times.most.to_seconds(),
                         part.from, part.until);
  }
  if (after(times.earliest, times.least, first) >= window.until) return std::nullopt;
  return first;
}

}  // namespace skein::refiners
