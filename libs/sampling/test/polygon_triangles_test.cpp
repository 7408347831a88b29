// SPDX-License-Identifier: Apache-2.0
#include "polygon_triangles.hpp"

#include <gtest/gtest.h>

#include "worlds.hpp"

namespace skein::sampling {
namespace {

using world::Polygon;
using world::Vector2;

double area_of(const std::array<Vector2, 3>& t) {
  return ((t[1] - t[0]).x() * (t[2] - t[0]).y() - (t[1] - t[0]).y() * (t[2] - t[0]).x()) / 2;
}

double total_area(const Polygon& polygon) {
  double total = 0;
  for (const auto& triangle : triangles_of(polygon)) {
    EXPECT_GT(area_of(triangle), 0);
    total += area_of(triangle);
  }
  return total;
}

TEST(PolygonTriangles, FillAConcavePolygonOfEitherSense) {
  Polygon bay = {{0, 0}, {10, 0}, {10, 10}, {7, 10}, {7, 2}, {3, 2}, {3, 10}, {0, 10}};

  EXPECT_NEAR(total_area(bay), 100 - 32, 1e-9);
  std::reverse(bay.begin(), bay.end());
  EXPECT_NEAR(total_area(bay), 100 - 32, 1e-9);
}

TEST(PolygonTriangles, LeaveCornersInLineAlone) {
  const Polygon square = {{0, 0}, {5, 0}, {10, 0}, {10, 5}, {10, 10}, {5, 10}, {0, 10}, {0, 5}};

  EXPECT_NEAR(total_area(square), 100, 1e-9);
}

TEST(PolygonTriangles, CoverWhatThePolygonContainsAndNothingElse) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Polygon polygon = a_star(random, "star").polygon;
    const auto triangles = triangles_of(polygon);

    EXPECT_NEAR(total_area(polygon), world::area(polygon), 1e-6);
    for (int k = 0; k < 100; ++k) {
      const Vector2 point =
          polygon.front() + Vector2(random.uniform(-100, 100), random.uniform(-100, 100));
      int within = 0;
      for (const auto& [a, b, c] : triangles) within += world::contains({a, b, c}, point);
      ASSERT_EQ(within, world::contains(polygon, point) ? 1 : 0);
    }
  }
}

}  // namespace
}  // namespace skein::sampling
