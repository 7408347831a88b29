// SPDX-License-Identifier: Apache-2.0
#include "skein/world/ground_normal.hpp"

namespace skein::world {

Vector3 ground_normal(const Terrain& terrain, double x, double y) {
  const double h = terrain.spec().cell / 2;
  const double east = terrain.elevation(x + h, y) - terrain.elevation(x - h, y);
  const double north = terrain.elevation(x, y + h) - terrain.elevation(x, y - h);
  return Vector3(-east / (2 * h), -north / (2 * h), 1).normalized();
}

}  // namespace skein::world
