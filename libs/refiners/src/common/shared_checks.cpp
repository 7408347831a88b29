// SPDX-License-Identifier: Apache-2.0
#include "common/shared_checks.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace skein::refiners {

std::string rounded(double figure) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", figure);
  return text.data();
}

std::string figure(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

Refusal bad(std::string field, std::string why) {
  return {RefusalKind::kBadQuery, std::move(field), std::move(why)};
}

std::optional<Refusal> check_in_world(const world::Polygon& area, const world::World& world,
                                      const std::string& field) {
  const world::TerrainSpec& ground = world.terrain.spec();
  world::Vector2 low = area.front(), high = area.front();
  for (const world::Vector2& corner : area) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const double gap = std::max({ground.west - high.x(), low.x() - ground.east,
                               ground.south - high.y(), low.y() - ground.north});
  if (gap < 0) return std::nullopt;
  return bad(field, "it is outside the world, by " + rounded(gap) +
                        " m: the ground is known from [" + rounded(ground.west) + ", " +
                        rounded(ground.south) + "] to [" + rounded(ground.east) + ", " +
                        rounded(ground.north) + "]");
}

std::optional<Refusal> check_energy(double energy, const world::VehicleModel& vehicle,
                                    const std::string& what) {
  const double usable = 1 - vehicle.energy.reserve;
  if (energy <= usable) return std::nullopt;
  return Refusal{RefusalKind::kBeyondVehicle, "vehicle.energy",
                 what + " takes " + rounded(100 * energy) + " % of the energy held when full; " +
                     rounded(100 * usable) + " % may be used"};
}

}  // namespace skein::refiners
