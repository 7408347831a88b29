// SPDX-License-Identifier: Apache-2.0
#include "refinery/zone_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace skein::supervisor {

using world::Polygon;
using world::Vector2;
using world::Vector3;

namespace {

constexpr std::size_t kMostCells = 100'000;
constexpr double kCellsAcross = 6;  // of a zone, at least
constexpr int kFinerGrounds = 8;    // tried, until some cell has its middle in a sliver

}  // namespace

Box box_of(const Polygon& polygon) {
  Box box{polygon.front(), polygon.front()};
  for (const Vector2& corner : polygon) {
    box.low = box.low.cwiseMin(corner);
    box.high = box.high.cwiseMax(corner);
  }
  return box;
}

Vector2 middle_of(const Polygon& polygon) {
  Vector2 sum = Vector2::Zero();
  for (const Vector2& corner : polygon) sum += corner;
  return sum / static_cast<double>(polygon.size());
}

double heading_to(const Vector3& from, const Polygon& polygon) {
  const Vector2 offset = middle_of(polygon) - from.head<2>();
  return std::atan2(offset.y(), offset.x());
}

world::GroundState ground_over(const Polygon& polygon, const world::GroundState& known,
                               double footprint) {
  const Box box = box_of(polygon);
  const Vector2 sides = box.high - box.low;
  double cell = std::min(footprint, std::max(1e-3, box.least_side()) / kCellsAcross);
  if (known.grid.size() > 0) cell = std::min(cell, known.grid.cell);
  world::GroundState ground;
  for (int i = 0; i < kFinerGrounds; ++i, cell /= 2) {
    cell = std::max(cell, std::sqrt(sides.prod() / static_cast<double>(kMostCells)));
    const auto cells = [&](double side) {
      return static_cast<std::size_t>(std::max(1.0, std::ceil(side / cell)));
    };
    ground.grid = {box.low.x(), box.low.y(), cell, cells(sides.x()), cells(sides.y())};
    ground.risk.clear();
    bool any = false;
    for (std::size_t at = 0; at < ground.grid.size(); ++at) {
      const Vector2 centre = ground.grid.centre(at);
      any = any || world::contains(polygon, centre);
      ground.risk.push_back(known.risk_at(centre));
    }
    if (any) break;
  }
  return ground;
}

Answer<double> footprint(const world::SensorModel& device, double height) {
  if (height <= 0 || height >= device.range)
    return no(device.device + " reaches " + std::to_string(std::lround(device.range)) +
              " m, and would look from " + std::to_string(std::lround(height)) +
              " m over the ground");
  const double reach = std::sqrt(device.range * device.range - height * height);
  return std::min(reach, height * std::tan(device.aperture));
}

}  // namespace skein::supervisor
