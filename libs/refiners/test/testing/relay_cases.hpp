// SPDX-License-Identifier: Apache-2.0
// Random hilly worlds with two that cannot hear each other, and exhaustive searches over them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/refiners/relay.hpp"
#include "testing/builders.hpp"

namespace skein::refiners::testing {

struct RelayCase {
  world::World world;
  RelayQuery query;
};

/// Hills over `across` × `across` × `levels` voxels of 20 m, a no-fly volume now and then, two ends
/// near the ground, and a radio that carries `reach` times the width of it all.
inline RelayCase random_relay_case(Random& random, std::int32_t across, std::int32_t levels,
                                   double reach) {
  const double side = 20 * across;
  world::TerrainSpec spec;
  spec.east = spec.north = side;
  spec.cell = 15;
  const auto somewhere = [&] {
    return world::Vector2(random.uniform(0, side), random.uniform(0, side));
  };
  for (int i = 0; i < 7; ++i)
    spec.hills.push_back(
        {somewhere(), random.uniform(0.2, 0.8) * 20 * levels, random.uniform(0.1, 0.4) * side});
  RelayCase result{level_world(), {}};
  result.world.terrain = world::Terrain(spec);
  result.world.airspace = {{0, 0, 0}, 20, {across, across, levels}};
  result.world.radio.range = reach * side;
  if (random.chance(0.5)) {
    const world::Vector2 at = somewhere();
    const double half = 0.15 * side;
    result.world.volumes.push_back(
        {"zone",
         {{at.x() - half, at.y() - half}, {at.x() + half, at.y() - half}, {at.x(), at.y() + half}},
         0,
         1000,
         {}});
  }
  const auto near_ground = [&] {
    const world::Vector2 at = somewhere();
    return world::Vector3(at.x(), at.y(), result.world.terrain.elevation(at.x(), at.y()) + 2);
  };
  result.query.vehicle = helicopter();
  result.query.vehicle.ceiling = random.chance(0.3) ? 0.5 * 20 * levels : 1e4;
  result.query.a = near_ground();
  result.query.b = near_ground();
  result.query.clearance = 5;
  result.query.least_margin = random.chance(0.5) ? 0 : random.uniform(0, 3);
  return result;
}

/// Every place a relay may take, by the definitions.
inline std::vector<world::Vector3> relay_places(const RelayCase& given) {
  world::AirspaceSpec spec;
  spec.grid = given.world.airspace;
  spec.clearance = given.query.clearance;
  spec.body_radius = given.query.vehicle.body_radius;
  spec.when.from = given.query.at;
  const world::Airspace air(spec, given.world.terrain, given.world.volumes);
  std::vector<world::Vector3> places;
  const auto& size = spec.grid.size;
  for (std::int32_t z = 0; z < size[2]; ++z)
    for (std::int32_t y = 0; y < size[1]; ++y)
      for (std::int32_t x = 0; x < size[0]; ++x) {
        if (!air.is_free(x, y, z)) continue;
        const world::Vector3 at =
            spec.grid.origin + spec.grid.voxel * world::Vector3(x + 0.5, y + 0.5, z + 0.5);
        if (at.z() - given.world.terrain.elevation(at.x(), at.y()) <= given.query.vehicle.ceiling)
          places.push_back(at);
      }
  return places;
}

struct Exhaustive {
  double margin = -std::numeric_limits<double>::infinity();
  std::uint64_t links = 0;
};

/// The best single relay by trying all places: -∞ when there is none.
inline Exhaustive best_of_all(const RelayCase& given) {
  Exhaustive best;
  const auto& world = given.world;
  for (const world::Vector3& at : relay_places(given)) {
    best.links += 2;
    const double weaker = std::min(world.radio.margin(given.query.a, at, world.terrain),
                                   world.radio.margin(at, given.query.b, world.terrain));
    if (weaker >= given.query.least_margin) best.margin = std::max(best.margin, weaker);
  }
  return best;
}

struct Widest {
  std::size_t relays = 0;
  double margin = 0;
};

/// Bellman-Ford over all places with at most `most` relays: the fewest hops, then the widest way.
inline std::optional<Widest> bellman_ford(const RelayCase& given, std::size_t most) {
  const auto& world = given.world;
  const auto places = relay_places(given);
  const auto link = [&](const world::Vector3& a, const world::Vector3& b) {
    const double margin = world.radio.margin(a, b, world.terrain);
    return margin >= given.query.least_margin ? margin : -1e9;
  };
  std::vector<double> width(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) width[i] = link(given.query.a, places[i]);
  for (std::size_t relays = 1; relays <= most; ++relays) {
    double best = -1e9;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (width[i] >= 0) best = std::max(best, std::min(width[i], link(places[i], given.query.b)));
    if (best >= 0) return Widest{relays, best};
    std::vector<double> next = width;
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t k = 0; k < places.size() && width[i] >= 0; ++k)
        if (width[i] > next[k])
          next[k] = std::max(next[k], std::min(width[i], link(places[i], places[k])));
    width = std::move(next);
  }
  return std::nullopt;
}

}  // namespace skein::refiners::testing
