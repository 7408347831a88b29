// SPDX-License-Identifier: Apache-2.0
#include "flyable/stations.hpp"

#include <cmath>
#include <numbers>

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;
constexpr double kPi = std::numbers::pi;

Vector2 left_of(double heading) { return {-std::sin(heading), std::cos(heading)}; }

/// The heading of each leg; a vertical one has that of the leg before it, or else after it.
std::vector<double> headings_of(const Way& corners) {
  std::vector<double> headings(corners.size() - 1, 0);
  std::size_t known = headings.size();
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const Vector2 leg = (corners[i + 1] - corners[i]).head<2>();
    const bool vertical = leg.norm() < 1e-9;
    if (!vertical) headings[i] = std::atan2(leg.y(), leg.x());
    if (vertical && i > 0) headings[i] = headings[i - 1];
    if (!vertical && known == headings.size()) {
      known = i;
      for (std::size_t k = 0; k < i; ++k) headings[k] = headings[i];
    }
  }
  return headings;
}

std::vector<Station> at_end(const Vector3& end, const std::optional<double>& asked, double along,
                            bool wide) {
  const auto heading = [&](double h) { return Station{{end.head<2>(), h}, end.z()}; };
  if (asked) return {heading(*asked)};
  std::vector<Station> stations;
  for (const double eighths : {0.0, 1.0, -1.0, 2.0, -2.0})
    stations.push_back(heading(along + eighths * kPi / 4));
  if (wide)
    for (const double eighths : {3.0, -3.0, 4.0})
      stations.push_back(heading(along + eighths * kPi / 4));
  return stations;
}

/// Rounded inside, flown over, swung around outside.
std::vector<Station> at_corner(const Vector3& corner, double in, double out, double radius,
                               bool wide) {
  const double turn = world::wrapped(out - in);
  const double bisector = in + turn / 2;
  const Vector2 outside = (turn > 0 ? -1 : 1) * left_of(bisector);
  std::vector<Station> stations;
  const auto add = [&](double outward, double heading) {
    const Vector2 at = corner.head<2>() + outward * outside;
    stations.push_back({{at, heading}, corner.z()});
  };
  const double cut = radius * (1 / std::max(1e-9, std::cos(turn / 2)) - 1);
  if (std::abs(turn) > 1e-9 && cut <= radius) add(-cut, bisector);
  add(0, bisector);
  if (std::abs(turn) > 0.05 || wide)
    for (const double outward : {0.25, 0.5, 1.0}) add(outward * radius, bisector);
  if (std::abs(turn) > 0.05) {
    add(0, in);
    add(0, out);
  }
  if (!wide) return stations;
  add(2 * radius, bisector);
  add(-radius, bisector);
  for (const double quarters : {1.0, 2.0, 3.0}) add(0, bisector + quarters * kPi / 2);
  return stations;
}

std::vector<Station> beside_leg(const Vector3& a, const Vector3& b, double heading, double radius) {
  const Vector3 middle = (a + b) / 2;
  std::vector<Station> stations;
  for (const double aside : {0.0, 1.0, -1.0, 2.0, -2.0})
    stations.push_back(
        {{middle.head<2>() + aside * radius * left_of(heading), heading}, middle.z()});
  return stations;
}

}  // namespace

std::vector<StationLayer> stations_of(const FlyableQuery& query, double radius, bool wide) {
  const Way& corners = query.corners;
  const std::vector<double> headings = headings_of(corners);
  const std::size_t last = corners.size() - 1;
  std::vector<StationLayer> layers = {
      {at_end(corners.front(), query.heading_from, headings.front(), wide), 0}};
  for (std::size_t i = 1; i <= last; ++i) {
    const double length = (corners[i] - corners[i - 1]).head<2>().norm();
    if (wide && length > 4 * radius)
      layers.push_back({beside_leg(corners[i - 1], corners[i], headings[i - 1], radius), i});
    layers.push_back({i == last ? at_end(corners[i], query.heading_to, headings[i - 1], wide)
                                : at_corner(corners[i], headings[i - 1], headings[i], radius, wide),
                      i});
  }
  return layers;
}

}  // namespace skein::refiners
