// SPDX-License-Identifier: Apache-2.0
// Rough grounds, and a judge of ways over them that shares nothing with the refiners: it has the
// raw posts, and walks.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/refiners/flight.hpp"
#include "testing/builders.hpp"

namespace skein::refiners::testing {

enum class Relief { kHills, kRaster, kBoth };

/// Posts over [-half, half]² and what stands on them.
struct RawGround {
  double half = 0, cell = 0;
  std::size_t across = 0;
  std::vector<double> posts;  ///< row by row from the south-west, hills and all

  double post(std::size_t column, std::size_t row) const { return posts[row * across + column]; }
  double at(double x, double y) const {
    const auto place = [&](double along) {
      return std::clamp((along + half) / cell, 0.0, static_cast<double>(across - 1) - 1e-12);
    };
    const double u = place(x), v = place(y);
    const auto i = static_cast<std::size_t>(u), j = static_cast<std::size_t>(v);
    const double s = u - static_cast<double>(i), t = v - static_cast<double>(j);
    return (1 - t) * ((1 - s) * post(i, j) + s * post(i + 1, j)) +
           t * ((1 - s) * post(i, j + 1) + s * post(i + 1, j + 1));
  }

  /// The least height of a way over the ground, looked at every quarter of a cell.
  double least_height(const Way& way) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < way.size(); ++i) {
      const world::Vector3 step = way[i] - way[i - 1];
      const double parts = std::ceil(4 * step.norm() / cell) + 1;
      for (double k = 0; k <= parts; ++k) {
        const world::Vector3 here = way[i - 1] + k / parts * step;
        least = std::min(least, here.z() - at(here.x(), here.y()));
      }
    }
    return least;
  }
};

/// Waves of falling height: ranges, ridges, and rough ground.
inline double raster_height(const std::vector<double>& phases, double x, double y, double relief) {
  double z = 0, height = relief / 2, length = 900;
  for (std::size_t k = 0; k + 1 < phases.size(); k += 2, height /= 3, length /= 2)
    z += height * std::sin(2 * std::numbers::pi *
                               (x * std::cos(phases[k]) + y * std::sin(phases[k])) / length +
                           phases[k + 1]);
  return z;
}

struct RoughWorld {
  world::World world;
  RawGround raw;
};

/// `relief`: heights of the ground differ by about twice as much [m].
inline RoughWorld rough_world(Relief kind, std::uint64_t seed, double relief, double half = 900,
                              double cell = 30) {
  Random random(seed, "ground");
  world::TerrainSpec spec;
  spec.west = spec.south = -half;
  spec.east = spec.north = half;
  spec.cell = cell;
  RawGround raw{half, cell, world::corners_of(spec).columns, {}};
  std::vector<double> phases(8);
  for (double& phase : phases) phase = random.uniform(0, 2 * std::numbers::pi);
  if (kind != Relief::kRaster)
    for (int i = 0; i < 5; ++i)
      spec.hills.push_back({{random.uniform(-half, half), random.uniform(-half, half)},
                            random.uniform(0.3, 1) * relief,
                            random.uniform(150, 400)});
  for (std::size_t row = 0; row < raw.across; ++row)
    for (std::size_t column = 0; column < raw.across; ++column) {
      const double x = -half + static_cast<double>(column) * cell;
      const double y = -half + static_cast<double>(row) * cell;
      double z = kind == Relief::kHills ? 0 : raster_height(phases, x, y, relief);
      if (kind != Relief::kHills) spec.elevations.push_back(z);
      for (const world::HillSpec& hill : spec.hills) {
        const double far = (world::Vector2(x, y) - hill.at).norm();
        if (far < hill.radius)
          z += hill.height * (1 + std::cos(std::numbers::pi * far / hill.radius)) / 2;
      }
      raw.posts.push_back(z);
    }
  RoughWorld rough{level_world(half), std::move(raw)};
  rough.world.terrain = world::Terrain(spec);
  const double low = rough.world.terrain.lowest(), high = rough.world.terrain.highest() + 200;
  rough.world.airspace.origin.z() = low;
  rough.world.airspace.size[2] = static_cast<std::int32_t>(std::ceil((high - low) / 20));
  rough.world.ground.grid = {-half, -half, 60, 30, 30};
  return rough;
}

}  // namespace skein::refiners::testing
