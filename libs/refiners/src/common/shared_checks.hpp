// SPDX-License-Identifier: Apache-2.0
// What the refusals of several services have in common; private.
#pragma once

#include <optional>
#include <string>

#include "skein/refiners/refinement.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/world.hpp"

namespace skein::refiners {

/// The refusal of what would use more than the vehicle holds above its reserve; `what` begins the
/// sentence.
std::optional<Refusal> check_energy(double energy, const world::VehicleModel& vehicle,
                                    const std::string& what);

/// "12.3": four digits, for people.
std::string rounded(double figure);
/// Up to six digits: as it was given.
std::string figure(double value);

/// A query whose `field` makes no sense.
Refusal bad(std::string field, std::string why);

/// An area of which nothing lies over the ground that the world knows (beyond it the ground is
/// taken to be as high as at its border). Precondition: at least one corner.
std::optional<Refusal> check_in_world(const world::Polygon& area, const world::World& world,
                                      const std::string& field);

}  // namespace skein::refiners
