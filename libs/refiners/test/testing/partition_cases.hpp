// SPDX-License-Identifier: Apache-2.0
// Random convex areas with anchors and shares, for the tests and benches of partition.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/refiners/partition.hpp"
#include "testing/builders.hpp"

namespace skein::refiners::testing {

inline double turn(const world::Vector2& a, const world::Vector2& b, const world::Vector2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Counter-clockwise convex hull (Andrew's monotone chain).
inline world::Polygon hull_of(std::vector<world::Vector2> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  world::Polygon hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const auto& point : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// A convex polygon of about that radius around a centre, never a sliver.
inline world::Polygon random_convex(Random& random, double radius, std::size_t points,
                                    const world::Vector2& centre = {0, 0}) {
  for (;;) {
    std::vector<world::Vector2> cloud;
    const double flat = random.uniform(0.2, 1), ring = random.uniform(0, 1);
    for (std::size_t i = 0; i < points; ++i) {
      const double angle = random.uniform(0, 2 * std::numbers::pi);
      const double out = radius * random.uniform(ring, 1);
      cloud.emplace_back(centre.x() + out * std::cos(angle),
                         centre.y() + out * flat * std::sin(angle));
    }
    world::Polygon polygon = hull_of(std::move(cloud));
    if (polygon.size() >= 3 && world::area(polygon) > 0.02 * radius * radius) return polygon;
  }
}

inline world::Vector2 on_border(Random& random, const world::Polygon& polygon) {
  const std::size_t i = random.below(polygon.size());
  const double along = random.chance(0.3) ? 0 : random.uniform();
  return polygon[i] + (polygon[(i + 1) % polygon.size()] - polygon[i]) * along;
}

inline world::Vector2 within(Random& random, const world::Polygon& polygon) {
  double total = 0;
  world::Vector2 sum = world::Vector2::Zero();
  for (const auto& corner : polygon) {
    const double weight = -std::log(1 - random.uniform());
    sum += corner * weight;
    total += weight;
  }
  return sum / total;
}

/// Three unlike helicopters (8, 12, 15 m/s; swaths of 40, 60, 80 m) that start anywhere in the
/// square around a convex area of 150 to 500 m radius, or that large times `larger`.
inline PartitionQuery three_unlike(Random& random, double larger = 1) {
  PartitionQuery query;
  const double radius = larger * random.uniform(150, 500);
  do query.area = random_convex(random, radius, 6 + random.below(6));
  while (world::area(query.area) < 0.5 * radius * radius);
  const double speeds[] = {8, 12, 15}, swaths[] = {40, 60, 80};
  for (std::size_t i = 0; i < 3; ++i) {
    Member member;
    member.uav = "uav" + std::to_string(i + 1);
    member.vehicle = helicopter();
    member.vehicle.energy.capacity *= 10;
    member.vehicle.cruise_speed = speeds[i];
    member.vehicle.max_speed = 20;
    member.swath = swaths[i];
    member.altitude = 50;
    member.start = {random.uniform(-radius, radius), random.uniform(-radius, radius)};
    query.members.push_back(std::move(member));
  }
  return query;
}

}  // namespace skein::refiners::testing
