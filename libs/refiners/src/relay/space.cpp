// SPDX-License-Identifier: Apache-2.0
#include "relay/space.hpp"

#include <cmath>

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

Space::Space(const RelayQuery& query, const world::World& world)
    : terrain_(world.terrain),
      radio_(world.radio),
      airspace_(spec_of(query, world), world.terrain, world.volumes),
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
