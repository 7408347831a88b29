// SPDX-License-Identifier: Apache-2.0
#include "flyable/lower.hpp"

#include <algorithm>

namespace skein::refiners {
namespace {

using world::Vector2;

/// Stations nearer in height than that are one [m].
constexpr double kSameHeight = 2;
/// The floor is asked for at so many places from one layer to the next.
constexpr int kAskedBetween = 4;

double highest_between(const Vector2& from, const Vector2& to, const Floor& floor) {
  double highest = floor(from);
  for (int i = 1; i <= kAskedBetween; ++i)
    highest = std::max(highest, floor(from + (to - from) * i / kAskedBetween));
  return highest;
}

/// The highest floor from the layer before each to the one after it, and the way to each from the
/// one before [m].
struct Floors {
  std::vector<double> low, steps;
};

Floors floors_under(const std::vector<StationLayer>& layers, const Floor& floor) {
  Floors floors{std::vector<double>(layers.size(), floor(layers[0].stations[0].pose.at)),
                std::vector<double>(layers.size(), 0)};
  double before = floors.low[0];
  for (std::size_t i = 1; i < layers.size(); ++i) {
    const Vector2 &last = layers[i - 1].stations[0].pose.at, &here = layers[i].stations[0].pose.at;
    const double between = highest_between(last, here, floor);
    floors.steps[i] = (here - last).norm();
    floors.low[i - 1] = std::max(before, between);
    floors.low[i] = before = between;
  }
  return floors;
}

/// Raised where the next floor could not be reached, or the last not be left, in time.
std::vector<double> within_slopes(const Floors& floors, const FlightLimits& limits) {
  std::vector<double> heights = floors.low;
  for (std::size_t i = 1; i < heights.size(); ++i)
    heights[i] = std::max(heights[i], heights[i - 1] - limits.descent * floors.steps[i]);
  for (std::size_t i = heights.size(); i-- > 1;)
    heights[i - 1] = std::max(heights[i - 1], heights[i] - limits.climb * floors.steps[i]);
  return heights;
}

}  // namespace

void add_lower_stations(std::vector<StationLayer>& layers, const FlightLimits& limits,
                        const Floor& floor) {
  if (layers.size() < 3) return;
  const Floors floors = floors_under(layers, floor);
  const std::vector<double> sloped = within_slopes(floors, limits);
  for (std::size_t i = 1; i + 1 < layers.size(); ++i) {
    auto& stations = layers[i].stations;
    const Station here = stations.front();
    for (const double z : {sloped[i], floors.low[i]})
      if (z <= stations.back().z - kSameHeight) stations.push_back({here.pose, z});
  }
}

}  // namespace skein::refiners
