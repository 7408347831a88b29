// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/own_ways.hpp"

#include <algorithm>

#include "flight/flight_times.hpp"
#include "refinery/refinery.hpp"
#include "safety/warning.hpp"
#include "skein/world/crossing.hpp"

namespace skein::supervisor {

using world::Vector3;

namespace {

constexpr std::uint64_t kSeed = 1;

bool closes_around(const world::Volume& volume, const world::VehicleModel& vehicle, MissionTime now,
                   const Vector3& at) {
  return volume.when.overlaps({now, now + kWarning}) &&
         crosses(volume, vehicle.body_radius + stay_radius(vehicle), at, at);
}

}  // namespace

std::optional<WayOut> way_out(const std::shared_ptr<const Knowledge>& knowledge,
                              const std::shared_ptr<const world::World>& world, MissionTime now,
                              const Vector3& at) {
  const auto around =
      std::find_if(world->volumes.begin(), world->volumes.end(), [&](const world::Volume& volume) {
        return closes_around(volume, knowledge->vehicle, now, at);
      });
  if (around == world->volumes.end()) return std::nullopt;
  Refinery refinery(Gazetteer(knowledge, world), now, kSeed);
  const auto out = refinery.ways.way_out(at);
  if (!out) return std::nullopt;
  return WayOut{around->name, out->way.back()};
}

std::vector<std::string> closed_around(const Knowledge& knowledge, const world::World& world,
                                       MissionTime now, const Vector3& at) {
  std::vector<std::string> names;
  for (const world::Volume& volume : world.volumes)
    if (closes_around(volume, knowledge.vehicle, now, at)) names.push_back(volume.name);
  return names;
}

std::vector<Vector3> own_way(const std::shared_ptr<const Knowledge>& knowledge,
                             const std::shared_ptr<const world::World>& world, MissionTime now,
                             const Vector3& from, const Vector3& to) {
  if (world->volumes.empty() && !knowledge->vehicle.ground) return {from, to};
  Refinery refinery(Gazetteer(knowledge, world), now, kSeed);
  const auto way = refinery.ways.path(from, to);
  return way && way->way.size() > 1 ? way->way : std::vector<Vector3>{from, to};
}

}  // namespace skein::supervisor
