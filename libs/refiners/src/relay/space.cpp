// SPDX-License-Identifier: Apache-2.0
#include "relay/space.hpp"

#include <cmath>
#include <utility>

namespace skein::refiners::relay {
namespace {

world::AirspaceSpec spec_of(const RelayQuery& query, const world::World& world) {
  world::AirspaceSpec spec;
  spec.grid = world.airspace;
  spec.clearance = query.clearance;
  spec.body_radius = query.vehicle.body_radius;
  spec.when.from = query.at;
  return spec;
}

}  // namespace

std::optional<Space> Space::in_time(const RelayQuery& query, const world::World& world,
                                    const Budget& budget) {
  auto airspace = world::Airspace::in_time(spec_of(query, world), world.terrain, world.volumes,
                                           budget.time_is_up);
  if (!airspace) return std::nullopt;
  return Space(query, world, std::move(*airspace));
}

Space::Space(const RelayQuery& query, const world::World& world, world::Airspace airspace)
    : terrain_(world.terrain),
      radio_(world.radio),
      airspace_(std::move(airspace)),
      ceiling_(query.vehicle.ceiling),
      least_margin_(query.least_margin) {}

bool Space::is_open(const Voxel& voxel) const {
  if (!airspace_.is_free(voxel)) return false;
  const Vector3 at = centre(voxel);
  return at.z() - terrain_.elevation(at.x(), at.y()) <= ceiling_;
}

double Space::longest_link() const {
  const double exponent = radio_.budget ? radio_.budget->path_loss_exponent : 2;
  return radio_.reach() / std::pow(10, least_margin_ / (10 * exponent));
}

}  // namespace skein::refiners::relay
